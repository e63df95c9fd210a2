#include "reference/openfoam/foam_mesh.hpp"

#include "reference/openfoam/cell_search.hpp"
#include "reference/openfoam/cubes.hpp"

#include <gtest/gtest.h>

#include <random>

namespace reference::openfoam {
namespace {

TEST(FoamMesh, MeasuresPolyhedra) {
  const FoamMesh mesh = cubes(4);
  EXPECT_NEAR(volume(mesh), 1, 1e-14);
  EXPECT_EQ(mesh.cells(), 64U);
  EXPECT_NEAR((mesh.cell_centres[0] - pfv::Vec3::Constant(0.125)).norm(), 0, 1e-14);
  EXPECT_NEAR(mesh.area(0).x(), 1.0 / 16, 1e-15);
  EXPECT_NEAR((mesh.centre(0) - pfv::Vec3(0.25, 0.125, 0.125)).norm(), 0, 1e-15);
  EXPECT_NEAR(non_orthogonality(mesh), 0, 1e-4);
}

TEST(CellSearch, FindsTheCellOfAPoint) {
  const FoamMesh mesh = cubes(5);
  const CellSearch search(mesh);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int k = 0; k < 1000; ++k) {
    const pfv::Vec3 point(uniform(random), uniform(random), uniform(random));
    const auto cell = search.cell_of(point);
    ASSERT_TRUE(cell);
    EXPECT_LT((mesh.cell_centres[*cell] - point).cwiseAbs().maxCoeff(), 0.1 + 1e-12);
  }
  EXPECT_TRUE(search.cell_of(pfv::Vec3(1, 1, 1)));
  EXPECT_TRUE(search.cell_of(pfv::Vec3(1.05, 0.5, 0.5))); // beyond a facet of a sphere, say
  EXPECT_FALSE(search.cell_of(pfv::Vec3(1.5, 0.5, 0.5)));
}

} // namespace
} // namespace reference::openfoam
