#pragma once

#include "pfv/problem/packing.hpp"

#include <array>

namespace reference::lattice_boltzmann {

/// Cubic voxels that fill a box, as nearly as its sides allow.
struct VoxelGrid {
  std::array<int, 3> voxels{};
  double size = 0;   // m, of a voxel
  double misfit = 0; // the largest relative difference between a side and its voxels; the packing is stretched by it

  double count() const { return static_cast<double>(voxels[0]) * voxels[1] * voxels[2]; }
};

/// Largest misfit that is answered.
inline constexpr double largest_misfit = 1e-3;

/// Voxels of a tenth of the mean radius times `mesh_size`, at least eight along each side, when sides match within
/// 1e-6; else the numbers within a fifth of that with the smallest misfit.
VoxelGrid voxel_grid(const pfv::Packing& packing, double mesh_size);

} // namespace reference::lattice_boltzmann
