#pragma once

#include "studies/motion/stability/trial.hpp"

namespace studies {

/// Explicit steps below and above the limit that is predicted, and far above, where the run must stop with a message
/// that names the limit.
std::vector<Trial> explicit_trials();

/// Semi-implicit steps of 20 and 100 times the explicit limit.
std::vector<Trial> implicit_trials();

} // namespace studies
