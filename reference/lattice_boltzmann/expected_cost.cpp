#include "reference/lattice_boltzmann/expected_cost.hpp"

#include "reference/lattice_boltzmann/pore_width.hpp"
#include "reference/lattice_boltzmann/velocities.hpp"

namespace reference::lattice_boltzmann {

namespace {

// Measured from 2e3 to 1e6 voxels on one core: 3.3e-8 to 4.5e-8 s for a step of a voxel, solid ones included; memory
// within 5 %.
constexpr double seconds_to_start = 0.2;
constexpr double seconds_of_step = 4.2e-8;
constexpr double bytes_of_process = 1.8e7;
constexpr double bytes_of_voxel = 240;
constexpr double links_to_area = 5.5;
constexpr double bytes_of_link = 160;

} // namespace

Estimate expected_cost(const pfv::Case& problem, const VoxelGrid& grid, int ranks) {
  const VoidMeasures measures = void_measures(problem, grid);
  return {static_cast<double>(directions) * measures.width * measures.surface,
          seconds_to_start * ranks + seconds_of_step * measures.steps_to_rest() * grid.count(),
          bytes_of_process * ranks + bytes_of_voxel * grid.count() + bytes_of_link * links_to_area * measures.surface};
}

} // namespace reference::lattice_boltzmann
