#pragma once

#include "pfv/problem/case.hpp"
#include "studies/runner/study_file.hpp"

#include <filesystem>
#include <string>

namespace studies {

/// A case with all its spheres, and the file every method's process reads it from.
struct StoredCase {
  pfv::Case problem;
  std::string digest;
  std::filesystem::path file;
};

/// The question of a study's case. Throws pfv::InputError.
pfv::Case problem_of(const StudyCase& one);

/// Reads the question of a study's case and writes it out in full, once: a generated packing is not generated again
/// while its question and `generation` (what the generators' results depend on) stay the same. Throws pfv::InputError
/// led by the place in the study.
StoredCase store_case(const StudyCase& one, const std::filesystem::path& folder, const std::string& generation);

} // namespace studies
