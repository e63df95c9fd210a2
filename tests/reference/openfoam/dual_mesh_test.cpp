#include "reference/openfoam/dual_mesh.hpp"

#include "pfv/problem/error.hpp"
#include "reference/openfoam/cubes.hpp"

#include <gtest/gtest.h>

namespace reference::openfoam {
namespace {

constexpr std::size_t n = 3;

TEST(DualMesh, HasACellForEachPointAndAFaceForEachEdge) {
  const FoamMesh mesh = cubes(n), dual = dual_mesh(mesh);
  EXPECT_EQ(dual.cells(), mesh.points.size());
  EXPECT_EQ(dual.neighbour.size(), 3 * n * (n + 1) * (n + 1));
}

TEST(DualMesh, FillsTheBoxWithItsPatches) {
  const FoamMesh dual = dual_mesh(cubes(n));
  EXPECT_NEAR(volume(dual), 1, 1e-12);
  ASSERT_EQ(dual.patches.size(), 6U);
  for (const MeshPatch& patch : dual.patches) {
    pfv::Vec3 area = pfv::Vec3::Zero();
    for (std::size_t face = patch.first; face < patch.first + patch.faces; ++face)
      area += dual.area(face);
    EXPECT_NEAR((area - pfv::outward_normal(std::get<pfv::Face>(patch.part))).norm(), 0, 1e-12) << patch.name;
  }
}

TEST(DualMesh, CellsAreClosedAndFacesPointFromTheLowerCellToTheHigher) {
  const FoamMesh dual = dual_mesh(cubes(n));
  std::vector<pfv::Vec3> sums(dual.cells(), pfv::Vec3::Zero());
  for (std::size_t face = 0; face < dual.faces(); ++face) {
    const pfv::Vec3 area = dual.area(face);
    sums[dual.owner[face]] += area;
    if (face >= dual.neighbour.size())
      continue;
    sums[dual.neighbour[face]] -= area;
    EXPECT_LT(dual.owner[face], dual.neighbour[face]);
    EXPECT_GT(area.dot(dual.cell_centres[dual.neighbour[face]] - dual.cell_centres[dual.owner[face]]), 0);
  }
  for (const pfv::Vec3& sum : sums)
    EXPECT_NEAR(sum.norm(), 0, 1e-12);
}

// Two patches that share a point in one cell's corner: the same face listed twice has edges of three faces.
TEST(DualMesh, RefusesABoundaryThatIsNoSurface) {
  FoamMesh mesh = cubes(1 + 1);
  const std::size_t last = mesh.faces() - 1;
  const std::vector<std::size_t> again(mesh.face(last).begin(), mesh.face(last).end());
  mesh.add_face(again);
  mesh.owner.push_back(mesh.owner[last]);
  ++mesh.patches.back().faces;
  EXPECT_THROW(dual_mesh(mesh), pfv::SolveError);
}

} // namespace
} // namespace reference::openfoam
