#pragma once

#include "studies/motion/stability/trial.hpp"

namespace studies {

/// Whether the fluid only takes energy, by size ratio. At rest: the matrix by which it resists motion, which must be
/// symmetric and have no negative eigenvalue. Plotted: ratio, smallest eigenvalue over the largest, asymmetry.
std::vector<Trial> resistance_trials();

/// In motion: the energy that it takes in a step, and the energy balance of a run. Plotted: ratio, what the balance
/// misses.
std::vector<Trial> energy_trials();

} // namespace studies
