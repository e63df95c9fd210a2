#include "pfv/simulation/relax.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace pfv {
namespace {

constexpr std::size_t steps_between_looks = 200;

/// The largest relative difference between the stress on a loaded wall and what grains do to it, and between the stress
/// that grains grow to and theirs.
double stress_error(const GrainCycle& cycle) {
  double largest = 0;
  if (const auto& growth = cycle.scene.growth)
    largest = std::abs(mean_stress(contact_stress(cycle.grains, cycle.contacts)) / growth->stress - 1);
  for (const Face face : all_faces)
    if (const auto* loaded = std::get_if<LoadedWall>(&cycle.scene.walls.motion[index(face)]); loaded) {
      const double carried = std::abs(cycle.on_wall[index(face)]) / area_of(cycle.grains.packing.box, face);
      largest = std::max(largest, std::abs(carried - loaded->stress) / std::max(loaded->stress, 1e-300));
    }
  return largest;
}

} // namespace

bool in_equilibrium(const GrainCycle& cycle, const Equilibrium& wanted) {
  return cycle.unbalanced_force() <= wanted.unbalanced_force && stress_error(cycle) <= wanted.stress;
}

std::size_t relax(GrainCycle& cycle, const Equilibrium& wanted, Clock& clock) {
  for (std::size_t steps = 0; steps < wanted.most_steps;) {
    const double step = limits_of(cycle).chosen();
    for (std::size_t k = 0; k < steps_between_looks; ++k, ++steps)
      cycle.advance(step, clock);
    if (in_equilibrium(cycle, wanted))
      return steps;
  }
  throw SolveError(fmt::format("the grains did not settle in {} steps: unbalanced force {:.2g} (wanted {:.2g}), stress "
                               "that is asked for off by {:.2g} (wanted {:.2g})",
                               wanted.most_steps, cycle.unbalanced_force(), wanted.unbalanced_force,
                               stress_error(cycle), wanted.stress));
}

} // namespace pfv
