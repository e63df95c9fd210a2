#include "meshing/contact_bridges.hpp"

#include "pfv/problem/generate.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace {

using meshing::bridged_gap;
using meshing::contact_bridges;
using pfv::Lattice;

std::size_t count(const pfv::Packing& packing) {
  return contact_bridges(packing, 0.2).size();
}

pfv::Packing pair_with_gap(double gap, double radius_1 = 0.2, double radius_2 = 0.1) {
  pfv::Packing packing;
  packing.spheres = {{{0.3, 0.5, 0.5}, radius_1}, {{0.3 + radius_1 + radius_2 + gap, 0.5, 0.5}, radius_2}};
  return packing;
}

pfv::Packing touching(Lattice lattice, int cells) {
  return pfv::lattice_packing(lattice, pfv::touching_solid_fraction(lattice), cells);
}

TEST(ContactBridges, OnePerContactOfALattice) {
  EXPECT_EQ(count(touching(Lattice::simple_cubic, 1)), 6);              // walls
  EXPECT_EQ(count(touching(Lattice::simple_cubic, 3)), 3 * 18 + 6 * 9); // pairs and walls
  EXPECT_EQ(count(touching(Lattice::bcc, 1)), 8);                       // centre to corners
  EXPECT_EQ(count(touching(Lattice::fcc, 1)), 6 * 4 + 12);              // face centres to corners and to each other
  EXPECT_EQ(count(pfv::nine_spheres()), 8 + 8 * 3);
  EXPECT_EQ(count(pfv::lattice_packing(Lattice::bcc, 0.5, 2)), 0);
}

TEST(ContactBridges, AreNamedByWhatTheyJoin) {
  const auto bridges = contact_bridges(pfv::nine_spheres(), 0.2);
  const auto named = [&](const std::string& name) { return std::ranges::count(bridges, name, &meshing::Bridge::name); };
  EXPECT_EQ(named("bridge_0_8") + named("bridge_8_0"), 1);
  EXPECT_EQ(named("bridge_0_1"), 0);
  std::size_t walls = 0;
  for (std::size_t k = 0; k < 9; ++k)
    for (const char* face : {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"})
      walls += static_cast<std::size_t>(named("bridge_" + std::to_string(k) + "_" + face));
  EXPECT_EQ(walls, 24);
}

TEST(ContactBridges, ReachFromInsideOneSphereIntoTheOther) {
  const auto packing = pair_with_gap(0);
  const auto bridge = contact_bridges(packing, 0.25).at(0);
  EXPECT_EQ(bridge.name, "bridge_0_1");
  EXPECT_DOUBLE_EQ(bridge.radius, 0.025); // of the smaller sphere
  for (const auto& [end, sphere] :
       {std::pair{bridge.from, packing.spheres[0]}, std::pair{bridge.to, packing.spheres[1]}})
    EXPECT_LT(std::hypot((end - sphere.centre).norm(), bridge.radius), 0.9 * sphere.radius);
}

TEST(ContactBridges, LeaveTheBoxAtAWall) {
  pfv::Packing packing;
  packing.spheres = {{{0.5, 0.5, 0.8}, 0.2}};
  const auto bridge = contact_bridges(packing, 0.2).at(0);
  EXPECT_EQ(bridge.name, "bridge_0_z_max");
  EXPECT_GT(bridge.to.z(), 1);
  EXPECT_LT(bridge.from.z(), 1);
}

TEST(ContactBridges, StandWhereTheGapIsSmall) {
  EXPECT_EQ(count(pair_with_gap(0.99 * bridged_gap * 0.1)), 1);
  EXPECT_EQ(count(pair_with_gap(1.01 * bridged_gap * 0.1)), 0);
}

TEST(ContactBridges, AWallIsAMirror) {
  pfv::Packing packing;
  packing.spheres = {{{0.2 + 0.49 * bridged_gap * 0.2, 0.5, 0.5}, 0.2}};
  EXPECT_EQ(count(packing), 1);
  packing.spheres[0].centre.x() = 0.2 + 0.51 * bridged_gap * 0.2;
  EXPECT_EQ(count(packing), 0);
}

TEST(ContactBridges, HideASmallOverlapButNotALargeOne) {
  // Two spheres of radius r that overlap by e meet in a circle of radius sqrt(r e) for small e.
  const auto overlap = [](double of_bridge) { return -std::pow(of_bridge * 0.2 * 0.2, 2) / 0.2; };
  EXPECT_EQ(count(pair_with_gap(overlap(0.95), 0.2, 0.2)), 1);
  EXPECT_EQ(count(pair_with_gap(overlap(1.05), 0.2, 0.2)), 0);
  EXPECT_EQ(count(pair_with_gap(-0.1, 0.2, 0.2)), 0);
}

TEST(ContactBridges, ASphereInsideAnotherHasNone) {
  EXPECT_EQ(count(pair_with_gap(-0.2 + 1e-6)), 0);
}

TEST(ContactBridges, ASphereCutAtItsCentreHasNoneToThatWall) {
  EXPECT_EQ(count(pfv::lattice_packing(Lattice::fcc, 0.3, 1)), 0);
}

} // namespace
