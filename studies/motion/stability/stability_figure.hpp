#pragma once

#include "studies/motion/stability/trial.hpp"

namespace studies {

// What the figure is drawn from, and the gnuplot commands that draw it.

/// Lattice, jitter, changes of k by us and by the original; that against its own k at the largest jitter.
std::string jitter_csv(const std::vector<TrialRow>& rows);

/// Size ratio, asymmetry and share of negative eigenvalues by us and by the original, what the energy balance misses.
std::string passivity_csv(const std::vector<TrialRow>& rows);

extern const char* const stability_figure;

} // namespace studies
