// Fluid that enters a box through its top and leaves through its side, u = (x, 0, -z): inside the finite element
// spaces, with no pressure at all, so everything is exact to the solver's tolerance. It slides along both open faces.

#include "reference/stokes_fem/box_mesh.hpp"
#include "reference/stokes_fem/flow_on_mesh.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

namespace {

using pfv::Vec3;

reference::Answer around_the_corner(pfv::Tangential tangential) {
  pfv::Case problem;
  problem.packing.box = {Vec3(0, 0, 0), Vec3(1, 1, 1)};
  problem.fluid.viscosity = 3;
  problem.faces[1] = pfv::Pressure{-3, tangential}; // p - mu du_n/dn
  problem.faces[5] = pfv::Pressure{3, tangential};
  const auto file = std::filesystem::temp_directory_path() / ("corner_" + std::to_string(getpid()) + ".msh");
  write_box_mesh(file, problem.packing.box, {2, 2, 2}, {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"});
  pfv::Clock clock;
  const auto answer =
      reference::stokes_fem::flow_on_mesh(problem, file, 0.2, clock, {.points = {{0.3, 0.6, 0.9}}, .facets = {}});
  std::filesystem::remove(file);
  return answer;
}

constexpr double tolerance = 1e-7;

} // namespace

TEST(OpenFace, LetsFluidSlideAlongItWhenTangentialFlowIsFree) {
  const auto answer = around_the_corner(pfv::Tangential::free);
  EXPECT_NEAR(answer.face_flux[1], 1, tolerance);
  EXPECT_NEAR(answer.face_flux[5], -1, tolerance);
  EXPECT_NEAR(answer.point_pressures->at(0), 0, tolerance);
}

TEST(OpenFace, BearsTheSymmetricStress) {
  // 2 mu du_n/dn = 6 Pa outwards on the side, inwards on the top, and the walls opposite to them hold against it.
  const auto& walls = *around_the_corner(pfv::Tangential::free).wall_forces;
  const std::array<Vec3, 6> expected{Vec3(6, 0, 0), Vec3(-6, 0, 0), Vec3(0, 0, 0),
                                     Vec3(0, 0, 0), Vec3(0, 0, -6), Vec3(0, 0, 6)};
  for (std::size_t face = 0; face < 6; ++face)
    EXPECT_LT((walls[face] - expected[face]).norm(), 10 * tolerance) << pfv::face_names[face];
}

TEST(OpenFace, HoldsItBackWhenTangentialFlowIsZero) {
  EXPECT_LT(around_the_corner(pfv::Tangential::zero).face_flux[1], 0.5);
}
