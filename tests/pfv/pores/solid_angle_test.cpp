#include "solid_angle.hpp"

#include <gtest/gtest.h>
#include <numbers>

using pfv::solid_angle;
using pfv::Vec3;

namespace {

constexpr double pi = std::numbers::pi;

TEST(SolidAngle, OfAnOctantIsAnEighthOfTheSphere) {
  EXPECT_NEAR(solid_angle(Vec3::UnitX(), 2 * Vec3::UnitY(), 3 * Vec3::UnitZ()), pi / 2, 1e-15);
}

TEST(SolidAngle, ChangesSignWithOrientation) {
  const Vec3 a(1, .2, .1), b(-.3, 1, .4), c(.2, -.5, 1);
  EXPECT_DOUBLE_EQ(solid_angle(a, b, c), -solid_angle(a, c, b));
  EXPECT_DOUBLE_EQ(solid_angle(a, b, c), solid_angle(b, c, a));
}

TEST(SolidAngle, PassesPiWithoutAJump) { // where atan instead of atan2 loses a half turn
  const auto wide = [](double z) {
    const Vec3 up(0, 0, z);
    return solid_angle(Vec3(1, 0, 0) - up, Vec3(-.5, std::sqrt(3) / 2, 0) - up, Vec3(-.5, -std::sqrt(3) / 2, 0) - up);
  };
  for (const double z : {0.2, 0.1, 0.01, 0.001})
    EXPECT_LT(wide(z), 0);
  EXPECT_NEAR(wide(1e-9), -2 * pi, 1e-7);
  EXPECT_NEAR(wide(-1e-9), 2 * pi, 1e-7);
}

TEST(SolidAngle, OfATetrahedronsFourSidesFromInsideIsTheSphere) {
  const Vec3 v[4] = {{0, 0, 0}, {1, 0, 0}, {.2, 1, 0}, {.3, .1, 1}};
  const Vec3 inside = 0.1 * v[0] + 0.2 * v[1] + 0.3 * v[2] + 0.4 * v[3];
  double sum = 0;
  for (const auto& f : {std::array{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}})
    sum += solid_angle(v[f[0]] - inside, v[f[1]] - inside, v[f[2]] - inside);
  EXPECT_NEAR(sum, 4 * pi, 1e-14);
}

} // namespace
