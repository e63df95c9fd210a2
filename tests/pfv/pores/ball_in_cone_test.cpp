#include "ball_in_cone.hpp"

#include <gtest/gtest.h>
#include <numbers>
#include <random>

using namespace pfv;
using namespace pfv::testing;

namespace {

constexpr double pi = std::numbers::pi;

Vec3 random_direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Vec3(normal(random), normal(random), normal(random)).normalized();
}

/// Eight cones about a random frame tile all directions; their parts must tile the ball inside the box.
BallPart whole_ball(double radius, std::span<const WallCut> cuts, std::mt19937_64& random) {
  const Vec3 u = random_direction(random);
  const Vec3 v = u.cross(random_direction(random)).normalized();
  const Vec3 w = u.cross(v);
  BallPart sum;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-1.0, 1.0})
      for (const double c : {-1.0, 1.0}) {
        const auto part = ball_in_cone(radius, cuts, a * u, b * v, c * w);
        const double sign = a * b * c;
        sum.volume += sign * part.volume;
        sum.surface += sign * part.surface;
      }
  return sum;
}

TEST(BallInCone, OfAnUncutOctant) {
  const auto part = ball_in_cone(2, {}, Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ());
  EXPECT_NEAR(part.volume, 4 * pi / 3, 1e-14);
  EXPECT_NEAR(part.surface, 2 * pi, 1e-14);
}

TEST(BallInCone, LosesTheCapBehindOneWall) {
  std::mt19937_64 random(1);
  for (const double h : {0.0, 1e-9, 0.3, 0.9, 0.999999}) {
    const std::vector<WallCut> cuts{{Vec3::UnitX(), h}};
    for (int i = 0; i < 20; ++i) {
      const auto ball = whole_ball(1, cuts, random);
      const double tolerance = h > 0 && h < 1e-6 ? h : 1e-12; // the wall all but through the centre
      EXPECT_NEAR(ball.surface, 2 * pi * (1 + h), tolerance) << h;
      EXPECT_NEAR(ball.volume, 4 * pi / 3 - pi * (1 - h) * (1 - h) * (2 + h) / 3, tolerance) << h;
    }
  }
}

TEST(BallInCone, OfACentreOnEdgeAndCornerIsAQuarterAndAnEighth) {
  std::mt19937_64 random(2);
  std::vector<WallCut> cuts{{Vec3::UnitX(), 0}, {-Vec3::UnitY(), 0}};
  EXPECT_NEAR(whole_ball(1, cuts, random).volume, pi / 3, 1e-13);
  cuts.push_back({Vec3::UnitZ(), 0});
  EXPECT_NEAR(whole_ball(1, cuts, random).volume, pi / 6, 1e-13);
  EXPECT_NEAR(whole_ball(1, cuts, random).surface, pi / 2, 1e-13);
}

TEST(BallInCone, CutByTwoAndThreeWallsAgreesWithCounting) {
  const std::vector<WallCut> cuts{{Vec3::UnitX(), 0.4}, {-Vec3::UnitY(), 0.2}, {Vec3::UnitZ(), 0.5}};
  std::mt19937_64 random(3);
  for (std::size_t walls = 2; walls <= 3; ++walls) {
    const std::span<const WallCut> used(cuts.data(), walls);
    const auto ball = whole_ball(1, used, random);
    const auto again = whole_ball(1, used, random);
    EXPECT_NEAR(ball.volume, again.volume, 1e-12);
    EXPECT_NEAR(ball.surface, again.surface, 1e-12);
    constexpr int n = 120; // midpoints of a cubic grid: error about n^-1.5
    int inside = 0;
    for (int i = 0; i < n * n * n; ++i) {
      const Vec3 x = (Vec3(i % n, i / n % n, i / n / n) + Vec3::Constant(0.5)) * 2 / n - Vec3::Ones();
      bool in = x.squaredNorm() < 1;
      for (const auto& cut : used)
        in = in && cut.outward.dot(x) < cut.distance;
      inside += in;
    }
    EXPECT_NEAR(ball.volume, inside * 8.0 / (n * n * n), 2e-3);
  }
}

} // namespace
