#pragma once

#include "studies/runner/plan.hpp"
#include "studies/runner/study_run.hpp"

#include <filesystem>

namespace studies {

// `study run` and `study report` of a study of effects.

/// Does what is planned and not stored, writes report.md to the work folder and prints the table, or JSON. Returns the
/// exit code. Throws pfv::InputError when methods are named, of which there are none.
int run_effects_command(const std::filesystem::path& study_file, const Scope& scope, const RunSettings& settings,
                        bool json);

/// Writes report.md from what is stored, and prints; with `publish` also puts report and rows into the study's results.
void report_effects_command(const std::filesystem::path& study_file, const Scope& scope, const WorkFolder& work,
                            bool publish, bool json);

} // namespace studies
