#include "meshing/mesher/seams.hpp"

#include "pfv/problem/generate.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace {

using pfv::Vec3;

TEST(Seams, AreTheSameEveryTime) {
  const auto packing = pfv::nine_spheres();
  const auto bridges = meshing::contact_bridges(packing, 0.2);
  const auto one = mesher::turns_of_seams(meshing::with_images(packing, {}), bridges, 1);
  const auto again = mesher::turns_of_seams(meshing::with_images(packing, {}), bridges, 1);
  const auto other = mesher::turns_of_seams(meshing::with_images(packing, {}), bridges, 2);
  ASSERT_EQ(one.spheres.size(), packing.spheres.size());
  ASSERT_EQ(one.bridges.size(), bridges.size());
  for (std::size_t k = 0; k < one.spheres.size(); ++k) {
    EXPECT_EQ(one.spheres[k].coeffs(), again.spheres[k].coeffs());
    EXPECT_NE(one.spheres[k].coeffs(), other.spheres[k].coeffs());
  }
}

TEST(Seams, BridgesStandAlongTheirAxes) {
  const auto packing = pfv::nine_spheres();
  const auto bridges = meshing::contact_bridges(packing, 0.2);
  const auto turns = mesher::turns_of_seams(meshing::with_images(packing, {}), bridges, 1);
  for (std::size_t b = 0; b < bridges.size(); ++b)
    EXPECT_LT((turns.bridges[b] * Vec3::UnitZ() - (bridges[b].to - bridges[b].from).normalized()).norm(), 1e-12);
}

// Of the simple cubic lattice at contact: twelve degrees around each of six directions are rims of bridges.
TEST(Seams, KeepClearOfRims) {
  const auto packing = pfv::lattice_packing(pfv::Lattice::simple_cubic, 0.52359877559, 1);
  const auto bridges = meshing::contact_bridges(packing, 0.2);
  const double rim = std::asin(0.2);
  const auto turn = mesher::turns_of_seams(meshing::with_images(packing, {}), bridges, 1).spheres.at(0);
  for (const auto& bridge : bridges) {
    const Vec3 axis = (bridge.to - bridge.from).normalized();
    double nearest = std::numbers::pi; // of the seam to the axis
    for (int i = 0; i <= 1000; ++i) {
      const double latitude = std::numbers::pi * (i / 1000.0 - 0.5);
      const Vec3 point = turn * Vec3(std::cos(latitude), 0, std::sin(latitude));
      nearest = std::min(nearest, std::acos(std::clamp(point.dot(axis), -1.0, 1.0)));
    }
    EXPECT_GT(std::abs(nearest - rim), 0.25 * rim) << bridge.name;
  }
}

} // namespace
