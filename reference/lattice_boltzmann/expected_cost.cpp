#include "reference/lattice_boltzmann/expected_cost.hpp"

#include "reference/lattice_boltzmann/velocities.hpp"

#include <algorithm>

namespace reference::lattice_boltzmann {

Estimate expected_cost(const pfv::Packing& packing, const VoxelGrid& grid, int ranks) {
  const double fluid = grid.count() * std::clamp(1 - pfv::solid_fraction(packing), 0.2, 1.0);
  const double steps_to_rest = 1000;
  return {static_cast<double>(directions) * fluid, 0.2 * ranks + 5e-8 * steps_to_rest * grid.count(),
          2e7 * ranks + 240 * grid.count()};
}

} // namespace reference::lattice_boltzmann
