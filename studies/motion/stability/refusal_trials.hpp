#pragma once

#include "studies/motion/stability/trial.hpp"

namespace studies {

/// What no method can answer: `pfv permeability` is to refuse it in one line on standard error, with exit code 2 and
/// nothing on standard output.
std::vector<Trial> refusal_trials();

} // namespace studies
