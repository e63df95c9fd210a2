#pragma once

#include "pfv/simulation/grain_cycle.hpp"

#include <cstddef>

namespace pfv {

/// When grains count as being in equilibrium.
struct Equilibrium {
  double unbalanced_force = 1e-5; // see unbalanced_force
  double stress = 1e-3;           // relative, of that on each loaded wall, and of that to which grains grow
  std::size_t most_steps = 500'000;
};

/// Of the last load.
bool in_equilibrium(const GrainCycle& cycle, const Equilibrium& wanted);

/// Advances dry grains under the walls and loads of their scene, with its damping, until they are in equilibrium: the
/// preparation of a packing at a confining stress when walls are loaded or grains grow. Returns the steps it took.
/// Throws SolveError with what was reached when they do not settle.
std::size_t relax(GrainCycle& cycle, const Equilibrium& wanted, Clock& clock);

} // namespace pfv
