#include "pfv/pores/disc_part.hpp"

#include <gtest/gtest.h>
#include <numbers>
#include <vector>

using namespace pfv;

namespace {

constexpr double pi = std::numbers::pi;

TEST(WallCuts, AreThoseNearerThanTheRadius) {
  const Box box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_TRUE(wall_cuts({{.5, .5, .5}, .5}, box).empty());
  EXPECT_EQ(wall_cuts({{.5, .4, .5}, .45}, box).size(), 1u);
  EXPECT_EQ(wall_cuts({{0, 0, 1}, .1}, box).size(), 3u);
}

TEST(DiscInWedge, IsASectorWhereNoWallCuts) {
  EXPECT_NEAR(disc_in_wedge(2, {}, Vec3(3, 0, 0), Vec3(1, 1, 0)), 0.5 * 4 * pi / 4, 1e-14);
}

TEST(DiscInWedge, EndsAtWalls) {
  const std::vector<WallCut> cuts{{Vec3::UnitX(), 0.5}, {Vec3::UnitY(), 0.0}};
  // Half disc below y = 0, less the segment beyond x = 1/2 (half of a cap of half-angle 60 degrees).
  const double below =
      disc_in_wedge(1, cuts, Vec3(1, 0, 0), Vec3(0, -1, 0)) + disc_in_wedge(1, cuts, Vec3(0, -1, 0), Vec3(-1, 0, 0));
  EXPECT_NEAR(below, pi / 2 - (pi / 3 - 0.5 * std::sin(2 * pi / 3)) / 2, 1e-14);
  EXPECT_NEAR(disc_in_wedge(1, cuts, Vec3(1, 0, 0), Vec3(0, 1, 0)), 0, 1e-14);
  const std::vector<WallCut> tilted{{Vec3(1, 0, 1).normalized(), 0.5}}; // cuts the plane z = 0 at x = 1/sqrt(2)
  EXPECT_NEAR(disc_in_wedge(1, tilted, Vec3(1, -1, 0), Vec3(1, 1, 0)), 0.5, 1e-14);
}

} // namespace
