#include "pfv/problem/error.hpp"
#include "reference/stokes_fem/bridge_gaps.hpp"
#include "reference/stokes_fem/exact_surface.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace {

using namespace reference::stokes_fem;
using pfv::Face;
using pfv::Vec3;

const pfv::Packing pair_of_spheres{.box = {}, .spheres = {{{0.25, 0.5, 0}, 0.25}, {{0.75, 0.5, 0}, 0.25}}};

} // namespace

TEST(BoundaryLabels, AreReadFromNamesOfGroups) {
  EXPECT_EQ(label_of("y_max", 1), BoundaryLabel(BoxFace{Face::y_max}));
  EXPECT_EQ(label_of("sphere_12", 13), BoundaryLabel(SphereSurface{12}));
  EXPECT_EQ(label_of("bridge_3_11", 13), BoundaryLabel(Bridge{3, std::size_t{11}}));
  EXPECT_EQ(label_of("bridge_3_x_min", 13), BoundaryLabel(Bridge{3, Face::x_min}));
}

TEST(BoundaryLabels, RefuseOtherNames) {
  for (const char* name :
       {"", "fluid", "sphere_", "sphere_13", "sphere_-1", "sphere_1x", "bridge_1", "bridge_1_13", "bridge_1_w"})
    EXPECT_THROW(label_of(name, 13), pfv::SolveError) << name;
}

TEST(ExactSurface, OneSurfaceIsReachedAlongItsNormal) {
  const ExactSurface sphere = exact_surface(SphereSurface{0}, pair_of_spheres, 0.2);
  const Vec3 direction = Vec3(1, 2, 2) / 3;
  const auto found = project(Vec3(0.25, 0.5, 0) + 0.2 * direction, std::array{sphere}, 0.1);
  ASSERT_TRUE(found);
  EXPECT_LT((*found - Vec3(0.25, 0.5, 0) - 0.25 * direction).norm(), 1e-12);
}

TEST(ExactSurface, TwoSurfacesAreReachedOnTheirCircle) {
  const ExactSurface sphere = exact_surface(SphereSurface{0}, pair_of_spheres, 0.2);
  const ExactSurface bridge = exact_surface(Bridge{0, std::size_t{1}}, pair_of_spheres, 0.2);
  const auto found = project({0.48, 0.53, 0.03}, std::array{sphere, bridge}, 0.1);
  ASSERT_TRUE(found);
  EXPECT_NEAR((*found - Vec3(0.25, 0.5, 0)).norm(), 0.25, 1e-12);
  EXPECT_NEAR(std::hypot(found->y() - 0.5, found->z()), 0.05, 1e-12);
}

TEST(ExactSurface, APlaneAndItsTangentSphereAreNotReached) {
  const std::array surfaces{exact_surface(SphereSurface{0}, pair_of_spheres, 0.2),
                            exact_surface(BoxFace{Face::z_max}, pair_of_spheres, 0.2)};
  EXPECT_FALSE(project({0.3, 0.5, 0.9}, surfaces, 0.1));
}

TEST(Bridge, ItsEndIsHalvedByEveryFaceThatHoldsTheAxis) {
  const double disc = std::numbers::pi * 0.05 * 0.05;
  EXPECT_NEAR(bridge_section({0, std::size_t{1}}, pair_of_spheres, 0.2), disc / 2, 1e-15); // the axis lies in z_min
  EXPECT_NEAR(bridge_section({0, Face::x_min}, pair_of_spheres, 0.2), disc / 2, 1e-15);
  EXPECT_EQ(bridge_direction({0, Face::x_min}, pair_of_spheres), Vec3(-1, 0, 0));
}
