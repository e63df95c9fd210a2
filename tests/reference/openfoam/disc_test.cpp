#include "reference/openfoam/disc.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace reference::openfoam {
namespace {

const pfv::Box unit_box;
const double whole = std::numbers::pi * 0.04;

TEST(Disc, InsideCountsWhole) {
  EXPECT_NEAR(area_inside({{0.5, 0.5, 0.5}, pfv::Vec3(1, 2, 3).normalized(), 0.2}, unit_box), whole, 1e-14);
}

TEST(Disc, FacesHalveAndQuarterIt) {
  EXPECT_NEAR(area_inside({{0.5, 0, 0.5}, pfv::Vec3::UnitX(), 0.2}, unit_box), whole / 2, 1e-14);
  EXPECT_NEAR(area_inside({{0.5, 0, 1}, pfv::Vec3::UnitX(), 0.2}, unit_box), whole / 4, 1e-14);
}

TEST(Disc, InAFaceCountsWhole) {
  EXPECT_NEAR(area_inside({{1, 0.5, 0.5}, pfv::Vec3::UnitX(), 0.2}, unit_box), whole, 1e-14);
}

// Circular segment beyond a chord at distance r/2: r^2 (pi/3 - sqrt(3)/4).
TEST(Disc, LosesASegmentToAFace) {
  const double segment = 0.04 * (std::numbers::pi / 3 - std::sqrt(3.0) / 4);
  EXPECT_NEAR(area_inside({{0.5, 0.1, 0.5}, pfv::Vec3::UnitX(), 0.2}, unit_box), whole - segment, 0.005 * whole);
}

} // namespace
} // namespace reference::openfoam
