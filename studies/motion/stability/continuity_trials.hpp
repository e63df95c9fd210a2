#pragma once

#include "studies/motion/stability/trial.hpp"

namespace studies {

/// Lattices moved by a jitter, and a sphere at a small gap from a wall: k must tend to that of the exact lattice, of
/// the sphere that touches. Plotted: the jitter, the change of k; by the original, k itself.
std::vector<Trial> jitter_trials();
std::vector<Trial> gap_trials();

/// How far k may be from that of the limit when coordinates are off by this, relative to the cell or the sphere.
constexpr double allowed_change(double off) {
  return 1e-7 + 20 * off;
}

} // namespace studies
