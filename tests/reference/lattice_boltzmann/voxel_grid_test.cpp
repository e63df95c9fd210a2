#include "reference/lattice_boltzmann/voxel_grid.hpp"

#include <gtest/gtest.h>

namespace reference::lattice_boltzmann {
namespace {

pfv::Packing packing_in(const pfv::Vec3& size, double radius = 0.1) {
  return {{{1, 2, 3}, pfv::Vec3(1, 2, 3) + size}, {{{1.5, 2.5, 3.5}, radius}}};
}

TEST(VoxelGrid, FillsACubeAtAnyMeshSize) {
  for (const double mesh_size : {0.7, 1.0, 1.4, 2.0}) {
    const auto grid = voxel_grid(packing_in({1, 1, 1}), mesh_size);
    EXPECT_LT(grid.misfit, 1e-12);
    EXPECT_NEAR(grid.voxels[0] * grid.size, 1, 1e-12);
    EXPECT_EQ(grid.voxels[1], grid.voxels[2]);
    EXPECT_NEAR(0.1 / grid.size, 10 / mesh_size, 0.1);
  }
}

TEST(VoxelGrid, FindsTheNumberThatSidesHaveInCommon) {
  const auto grid = voxel_grid(packing_in({1, 1.5, 1.3}), 1.03); // about 97: 100 fits
  EXPECT_EQ(grid.voxels, (std::array{100, 150, 130}));
  EXPECT_LT(grid.misfit, 1e-6);
}

TEST(VoxelGrid, SharesTheMisfitOfSidesThatHaveNone) {
  const auto grid = voxel_grid(packing_in({1, 1.41421356, 1.7320508}), 1);
  EXPECT_GT(grid.misfit, 1e-6);
  EXPECT_LT(grid.misfit, largest_misfit);
  EXPECT_NEAR(grid.voxels[2] * grid.size, 1.7320508, 2e-3);
}

TEST(VoxelGrid, HasAtLeastEightVoxelsAlongASide) {
  EXPECT_EQ(voxel_grid(packing_in({1, 1, 1}, 0.4), 100).voxels, (std::array{8, 8, 8}));
}

} // namespace
} // namespace reference::lattice_boltzmann
