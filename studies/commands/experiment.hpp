#pragma once

#include "studies/motion/experiment.hpp"

namespace studies {

/// Runs it, writes its page into `work` (the study's own work folder when empty) and prints its summary. Returns the
/// exit code: 1 when what it is to show did not come out.
int run_experiment(const Experiment& experiment, bool quick, const std::filesystem::path& work);

/// Prints the page of its last run; with `publish` also copies it and its files into the study's results folder. Throws
/// pfv::InputError when there is none.
void report_experiment(const Experiment& experiment, bool publish, const std::filesystem::path& work);

} // namespace studies
