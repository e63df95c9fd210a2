#include "pfv/simulation/relax.hpp"

#include "pfv/problem/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace pfv {
namespace {

constexpr std::size_t steps_between_looks = 200;
constexpr double safe_step = 0.3; // of the contacts' limit, see StepLimits::chosen

/// The largest relative difference between the stress on a loaded wall and what grains do to it.
double wall_error(const GrainCycle& cycle) {
  double largest = 0;
  const Vec3 size = cycle.grains.packing.box.size();
  for (const Face face : all_faces)
    if (const auto* loaded = std::get_if<LoadedWall>(&cycle.scene.walls.motion[index(face)]); loaded) {
      const double area = size.prod() / size[index(axis_of(face))];
      const double carried = std::abs(cycle.on_wall[index(face)]) / area;
      largest = std::max(largest, std::abs(carried - loaded->stress) / std::max(loaded->stress, 1e-300));
    }
  return largest;
}

} // namespace

bool in_equilibrium(const GrainCycle& cycle, const Equilibrium& wanted) {
  return cycle.unbalanced_force() <= wanted.unbalanced_force && wall_error(cycle) <= wanted.wall_stress;
}

std::size_t relax(GrainCycle& cycle, const Equilibrium& wanted, Clock& clock) {
  for (std::size_t steps = 0; steps < wanted.most_steps;) {
    const double step = safe_step * cycle.contact_limit();
    for (std::size_t k = 0; k < steps_between_looks; ++k, ++steps)
      cycle.advance(step, clock);
    if (in_equilibrium(cycle, wanted))
      return steps;
  }
  throw SolveError(fmt::format("the grains did not settle in {} steps: unbalanced force {:.2g} (wanted {:.2g}), stress "
                               "on the loaded walls off by {:.2g} (wanted {:.2g})",
                               wanted.most_steps, cycle.unbalanced_force(), wanted.unbalanced_force, wall_error(cycle),
                               wanted.wall_stress));
}

} // namespace pfv
