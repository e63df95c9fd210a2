#include "pfv/simulation/neighbour_drift.hpp"

#include "pfv/problem/face.hpp"
#include "pfv/problem/generate.hpp"

#include <gtest/gtest.h>

using namespace pfv;

namespace {

constexpr double allowed = 1e-3;

struct TwoPores {
  Packing packing = random_packing({.spheres = 20, .solid_fraction = 0.3, .seed = 2});
  std::vector<std::array<int, 4>> pores{{0, 1, 2, 3}, {2, 5, 20 + index(Face::z_max), 7}};
  NeighbourDrift drift;
  TwoPores() { drift.start(packing); }
  bool exceeds() { return drift.exceeds(allowed, packing, pores); }
};

TEST(NeighbourDrift, IsNothingWhenAllMovesTogether) {
  TwoPores at;
  for (int n = 0; n < 100; ++n) {
    const Vec3 step(0.01, -0.02, 0.03);
    for (Sphere& sphere : at.packing.spheres)
      sphere.centre += step;
    at.packing.box.lower += step;
    at.packing.box.upper += step;
    ASSERT_FALSE(at.exceeds());
  }
}

TEST(NeighbourDrift, IsThatOfOneGrainOfAPore) {
  TwoPores at;
  at.packing.spheres[3].centre.x() += 0.9 * allowed;
  EXPECT_FALSE(at.exceeds());
  at.packing.spheres[3].centre.x() += 0.2 * allowed;
  EXPECT_TRUE(at.exceeds());
  at.drift.start(at.packing);
  EXPECT_FALSE(at.exceeds());
}

TEST(NeighbourDrift, GrainsSlideAlongAWallButNotFromIt) {
  TwoPores at;
  for (const int grain : {2, 5, 7, 0, 1, 3})
    at.packing.spheres[grain].centre += Vec3(1, 2, 0);
  EXPECT_FALSE(at.exceeds());
  at.packing.box.upper.z() += 2 * allowed;
  EXPECT_TRUE(at.exceeds());
}

TEST(NeighbourDrift, SeesWhatAddsUpInSmallSteps) {
  TwoPores at;
  int steps = 0;
  while (!at.exceeds() && steps < 1000) {
    at.packing.spheres[1].centre.y() += 0.01 * allowed;
    ++steps;
  }
  EXPECT_NEAR(steps, 100, 1);
}

} // namespace
