#include "pfv/pores/orthoscheme.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace pfv;

namespace {

constexpr double pi = std::numbers::pi;

/// Midpoints of a grid over k E R: y from 0 to x b / a; of each, the height inside the ball below P's.
double counted(double radius, double a, double b, double h) {
  constexpr int n = 300;
  double volume = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double x = (i + .5) / n * a, y = (j + .5) / n * x * b / a;
      const double inside = radius * radius - x * x - y * y;
      volume += x * (inside > 0 ? std::min(y * h / b, std::sqrt(inside)) : 0);
    }
  return volume * b / (double(n) * n);
}

TEST(Orthoscheme, IsASectorOfASmallBallAndAllOfItInALargeOne) {
  const auto small = ball_in_orthoscheme(.4, 1, 1, 1); // a 48th of all directions
  EXPECT_NEAR(small.volume, 4 * pi / 3 * .064 / 48, 1e-16);
  EXPECT_NEAR(small.surface, 4 * pi * .16 / 48, 1e-15);
  EXPECT_EQ(small.base, 0);
  const auto large = ball_in_orthoscheme(2, 1, .5, .8);
  EXPECT_NEAR(large.volume, .4 / 6, 1e-15);
  EXPECT_NEAR(large.surface, 0, 1e-14);
  EXPECT_NEAR(large.base, .2, 1e-15);
}

TEST(Orthoscheme, LosesTheCapBehindItsBase) { // an eighth of the directions before the base, if the disc ends before R
  const double r = 1, a = .6, disc = r * r - a * a;
  const auto part = ball_in_orthoscheme(r, a, 2, 2);
  const double whole = 2 * std::atan2(4, (std::hypot(a, 2) + std::hypot(a, 2, 2)) * (std::hypot(a, 2) + a));
  EXPECT_NEAR(part.surface, whole - pi / 4 * (1 - a), 1e-14);
  EXPECT_NEAR(part.volume, whole / 3 - pi / 4 * (1 - a) * (1 - a) * (2 + a) / 6, 1e-14);
  EXPECT_NEAR(part.base, pi / 8 * disc, 1e-15);
}

TEST(Orthoscheme, AgreesWithCountingWhereverTheSpherePasses) {
  const double a = .5, b = .4, h = .7;
  for (const double r : {.3, .55, .6, .64, .8, .94, 1.0}) // before E, between E and R, R and P, beyond P
    EXPECT_NEAR(ball_in_orthoscheme(r, a, b, h).volume, counted(r, a, b, h), 1e-5) << r;
}

TEST(Orthoscheme, GrowsByItsSurface) { // and is continuous where the sphere passes a corner
  const double a = .5, b = .4, h = .7, step = 1e-6;
  for (double r = .3; r < 1; r += .0137) {
    const auto before = ball_in_orthoscheme(r - step, a, b, h), after = ball_in_orthoscheme(r + step, a, b, h);
    EXPECT_NEAR((after.volume - before.volume) / (2 * step), ball_in_orthoscheme(r, a, b, h).surface, 1e-6) << r;
  }
}

TEST(Orthoscheme, HasTheSignOfItsEdges) {
  const auto part = ball_in_orthoscheme(.6, .5, .4, .7);
  for (const double a : {-1, 1})
    for (const double b : {-1, 1})
      for (const double h : {-1, 1}) {
        const auto other = ball_in_orthoscheme(.6, a * .5, b * .4, h * .7);
        EXPECT_EQ(other.volume, a * b * h * part.volume);
        EXPECT_EQ(other.surface, a * b * h * part.surface);
        EXPECT_EQ(other.base, b * h * part.base);
      }
}

TEST(Orthoscheme, IsNothingWithoutAnEdge) {
  for (const double r : {.3, .9}) {
    EXPECT_NEAR(ball_in_orthoscheme(r, 0, .4, .7).surface, 0, 1e-15);
    EXPECT_NEAR(ball_in_orthoscheme(r, .5, 0, .7).surface, 0, 1e-15);
    EXPECT_NEAR(ball_in_orthoscheme(r, .5, .4, 0).surface, 0, 1e-15);
    EXPECT_NEAR(ball_in_orthoscheme(r, 0, 0, .7).surface, 0, 1e-15);
  }
}

} // namespace
