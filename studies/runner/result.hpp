#pragma once

#include "studies/runner/compare.hpp"
#include "studies/runner/finding.hpp"
#include "studies/runner/study_file.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace studies {

/// What a method says about a case and how that compares.
struct Result {
  Finding finding;
  Comparison comparison;
};

/// What the method says about the case when it has a permeability, else a null pointer.
const Finding* with_permeability(std::span<const Result> results, const std::string& case_id,
                                 const std::string& method);

/// Groups rows by case and method, in the study's order, extrapolates each group and compares it with the study's
/// reference. Rows of cases and methods the study does not have are left out.
std::vector<Result> results(const Study& study, std::span<const Row> rows, const std::filesystem::path& answers);

} // namespace studies
