#pragma once

#include "reference/lattice_boltzmann/voxel_grid.hpp"
#include "reference/method.hpp"

namespace reference::lattice_boltzmann {

/// Unknowns: nineteen populations to each fluid voxel. Seconds and bytes by fits to measurements.
Estimate expected_cost(const pfv::Case& problem, const VoxelGrid& grid, int ranks);

} // namespace reference::lattice_boltzmann
