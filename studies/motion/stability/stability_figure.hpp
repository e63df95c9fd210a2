#pragma once

#include "studies/motion/stability/trial.hpp"

namespace studies {

// The figure: k against jitter, and passivity against the ratio of sizes.

/// The commands; what there is nothing of is left out.
std::string stability_figure(const std::vector<TrialRow>& rows);

/// Lattice, jitter, changes of k by us and by the original; that against its own k at the largest jitter.
std::string jitter_csv(const std::vector<TrialRow>& rows);

/// Size ratio, asymmetry and share of negative eigenvalues by us and by the original, what the energy balance misses.
std::string passivity_csv(const std::vector<TrialRow>& rows);

} // namespace studies
