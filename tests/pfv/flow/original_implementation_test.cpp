// Against FlowEngine of YADE 2023.02a on the same packings: the only difference in the conductances is the factor
// 2^(-1/2) it puts on a throat for each wall. Data and their known defects: tests/data/README.md.
#include "support/packings.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

using namespace pfv;
using namespace pfv::testing;

namespace {

struct Peer {
  const char* packing;
  std::size_t cells;
  double permeability;
};
constexpr Peer peers[] = {{"bcc9jit", 44, 7.977212e-4}, {"g200", 1101, 7.393406e-5}, {"g2000", 11645, 1.087566e-5}};

SteadyFlow flow_of(const Peer& peer, WallRule walls) {
  FlowOptions options;
  options.walls = walls;
  return solved(flow_through(packing_from(std::string(peer.packing) + ".txt"), Axis::y), options);
}

TEST(OriginalImplementation, HasTheSameCells) {
  for (const auto& peer : peers)
    EXPECT_EQ(flow_of(peer, MirrorWalls{}).network.pores.size(), peer.cells);
}

TEST(OriginalImplementation, PermeabilityFollowsFromItsWallFactors) {
  // What is left, .2 to .6 %, are spheres cut by walls and its clamp on extreme conductances.
  for (const auto& peer : peers)
    EXPECT_NEAR(*flow_of(peer, OriginalWalls{}).permeability / peer.permeability, 1, 0.01) << peer.packing;
}

TEST(OriginalImplementation, MirrorWallsAreMorePermeable) {
  EXPECT_NEAR(*flow_of(peers[1], MirrorWalls{}).permeability / peers[1].permeability, 1.26, 0.01);
  EXPECT_NEAR(*flow_of(peers[2], MirrorWalls{}).permeability / peers[2].permeability, 1.20, 0.01);
}

std::set<std::size_t> next_to_corners(const Packing& packing) {
  std::set<std::size_t> found;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 at(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    std::size_t nearest = 0;
    for (std::size_t k = 0; k < packing.spheres.size(); ++k)
      if ((packing.spheres[k].centre - at).norm() < (packing.spheres[nearest].centre - at).norm())
        nearest = k;
    found.insert(nearest);
  }
  return found;
}

TEST(OriginalImplementation, ForcesAgreeAwayFromTheCorners) {
  const auto flow = flow_of(peers[1], OriginalWalls{});
  const auto corners = next_to_corners(packing_from("g200.txt"));
  std::ifstream file(TEST_DATA "/g200.peer-forces.txt");
  double difference = 0, total = 0;
  std::size_t compared = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#'))
      continue;
    std::istringstream fields(line);
    std::size_t k;
    Vec3 force;
    fields >> k >> force[0] >> force[1] >> force[2];
    if (corners.contains(k))
      continue;
    difference += (flow.forces.of_flow(k) - force).squaredNorm();
    total += force.squaredNorm();
    ++compared;
  }
  EXPECT_EQ(compared, 192u);
  EXPECT_LT(std::sqrt(difference / total), 0.005);
}

} // namespace
