#pragma once

#include "studies/runner/study_file.hpp"
#include "studies/runner/study_values.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace studies {

/// Reads a [[case]] of a study in `folder` that asks `methods`: one case, or one for each of its seeds, of one label.
/// What the case does not say of its own budget is that of `budget`. Throws as read_study does.
std::vector<StudyCase> read_study_cases(const toml::node& node, const std::filesystem::path& folder,
                                        const std::vector<std::string>& methods, const Budget& budget);

} // namespace studies
