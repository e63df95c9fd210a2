#include "reference/lattice_boltzmann/voxel_grid.hpp"

#include <algorithm>
#include <cmath>

namespace reference::lattice_boltzmann {

namespace {

constexpr double voxels_per_radius = 10;
constexpr int fewest_voxels = 8;
constexpr double exact = 1e-6;

double mean_radius(const pfv::Packing& packing) {
  double sum = 0;
  for (const pfv::Sphere& sphere : packing.spheres)
    sum += sphere.radius;
  return sum / static_cast<double>(packing.spheres.size());
}

// With `shortest` voxels along the shortest side. Their size is in the middle of what the three sides ask for.
VoxelGrid grid_with(const pfv::Vec3& sides, int shortest) {
  VoxelGrid grid;
  const double guess = sides.minCoeff() / shortest;
  double least = guess;
  double most = guess;
  for (std::size_t a = 0; a < 3; ++a) {
    const double side = sides[static_cast<int>(a)];
    grid.voxels[a] = std::max(1, static_cast<int>(std::lround(side / guess)));
    least = std::min(least, side / grid.voxels[a]);
    most = std::max(most, side / grid.voxels[a]);
  }
  grid.size = (least + most) / 2;
  grid.misfit = (most - least) / (most + least);
  return grid;
}

} // namespace

VoxelGrid voxel_grid(const pfv::Packing& packing, double mesh_size) {
  const pfv::Vec3 sides = packing.box.size();
  const double wanted = voxels_per_radius / mesh_size * sides.minCoeff() / mean_radius(packing);
  const int middle = std::max(fewest_voxels, static_cast<int>(std::lround(std::min(wanted, 1e6))));
  VoxelGrid best = grid_with(sides, middle);
  for (int away = 1; best.misfit > exact && away <= std::max(2, middle / 5); ++away)
    for (const int shortest : {middle + away, std::max(fewest_voxels, middle - away)})
      if (const VoxelGrid grid = grid_with(sides, shortest); grid.misfit < best.misfit)
        best = grid;
  return best;
}

} // namespace reference::lattice_boltzmann
