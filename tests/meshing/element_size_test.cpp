#include "meshing/element_size.hpp"

#include "pfv/problem/generate.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace {

using meshing::ElementSize;

pfv::Packing pair_with_gap(double gap) {
  pfv::Packing packing;
  packing.box = {{-1, -1, -1}, {2, 2, 2}};
  packing.spheres = {{{0.5 - 0.2 - gap / 2, 0.5, 0.5}, 0.2}, {{0.5 + 0.2 + gap / 2, 0.5, 0.5}, 0.2}};
  return packing;
}

const pfv::Vec3 middle(0.5, 0.5, 0.5);

TEST(ElementSize, IsAFractionOfTheGap) {
  for (const double gap : {0.15, 0.17})
    EXPECT_NEAR(ElementSize(pair_with_gap(gap), 1)(middle), ElementSize::fraction * gap, 1e-12);
}

TEST(ElementSize, HasAFloorAtContacts) {
  EXPECT_NEAR(ElementSize(pair_with_gap(0.001), 1)(middle), ElementSize::contact * 0.2, 1e-12);
}

TEST(ElementSize, LeavesSixElementsAroundABridge) {
  for (const double mesh_size : {1.0, 2.0, 5.0})
    for (const double bridge_radius : {0.1, 0.2})
      EXPECT_LE(ElementSize(pair_with_gap(0.001), mesh_size, bridge_radius)(middle),
                1.001 * ElementSize::rim * bridge_radius * 0.2);
}

TEST(ElementSize, IsSmallerInAThroatThanAtAContact) {
  const auto packing = pfv::lattice_packing(pfv::Lattice::fcc, pfv::touching_solid_fraction(pfv::Lattice::fcc), 1);
  const ElementSize size(packing, 1);
  const pfv::Vec3 corner(0, 0, 0), a(0.5, 0.5, 0), b(0.5, 0, 0.5);
  EXPECT_LT(size((corner + a + b) / 3), 0.8 * size((a + b) / 2));
}

TEST(ElementSize, ScalesWithMeshSizeAndLength) {
  auto packing = pair_with_gap(0.16);
  const double expected = ElementSize(packing, 1)(middle);
  EXPECT_NEAR(ElementSize(packing, 0.5)(middle), expected / 2, 1e-12);
  packing.box = {1e-3 * packing.box.lower, 1e-3 * packing.box.upper};
  for (auto& [centre, radius] : packing.spheres) {
    centre *= 1e-3;
    radius *= 1e-3;
  }
  EXPECT_NEAR(ElementSize(packing, 1)(1e-3 * middle), 1e-3 * expected, 1e-15);
}

TEST(ElementSize, AWallHalvesAGap) {
  pfv::Packing packing;
  packing.spheres = {{{0.5, 0.5, 0.2 + 0.08}, 0.2}};
  EXPECT_NEAR(ElementSize(packing, 1)({0.5, 0.5, 0}), ElementSize(pair_with_gap(0.16), 1)(middle), 1e-12);
}

TEST(ElementSize, ASphereCutAtItsCentreIsNotItsOwnNeighbour) {
  pfv::Packing packing;
  packing.spheres = {{{0.5, 0.5, 0}, 0.1}};
  EXPECT_NEAR(ElementSize(packing, 1)({0.6, 0.5, 0}), ElementSize::largest * 0.1, 1e-12);
}

// The cell list must find the same three surfaces as a search through all of them.
TEST(ElementSize, AgreesWithASearchThroughAllSpheres) {
  const auto packing = pfv::random_packing({.spheres = 200, .solid_fraction = 0.3, .radius_ratio = 4, .seed = 5});
  const ElementSize size(packing, 1);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.2, 0.8); // mirror images are farther than three spheres here
  for (int draw = 0; draw < 500; ++draw) {
    const pfv::Vec3 point(uniform(random), uniform(random), uniform(random));
    std::vector<std::pair<double, double>> near; // distance, radius
    for (const auto& [centre, radius] : packing.spheres)
      near.emplace_back(std::max(0.0, (point - centre).norm() - radius), radius);
    std::ranges::sort(near);
    const double radius = std::min(near[0].second, near[1].second);
    const double floor = std::min(std::max(ElementSize::fraction * near[2].first, ElementSize::smallest * radius),
                                  ElementSize::contact * radius);
    double cap = 1;
    for (int k = 0; k < 2; ++k)
      cap = std::min(cap, ElementSize::largest * near[k].second + ElementSize::growth * near[k].first);
    const double expected = std::min(cap, std::max(floor, ElementSize::fraction * (near[0].first + near[1].first)));
    if (near[0].first == 0)
      continue; // inside spheres the order of equals is not defined
    EXPECT_NEAR(size(point), expected, 1e-12);
  }
}

} // namespace
