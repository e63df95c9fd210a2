#pragma once

#include "studies/motion/experiment.hpp"
#include "studies/motion/stability/trial.hpp"

namespace studies {

/// The worst of every bounded measure of a group, and that all of its cases are done.
std::vector<Expectation> expectations_of(const std::vector<TrialRow>& group);

/// One row for each case of a group: its measures, what is outside of its bound in bold, remarks and the original's
/// outcome.
Table trial_table(const std::vector<TrialRow>& group);

Table expectation_table(const std::vector<Expectation>& expectations);

std::string measures_csv(const std::vector<TrialRow>& rows);
std::string outcomes_csv(const std::vector<TrialRow>& rows);

} // namespace studies
