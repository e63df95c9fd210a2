// Functions without branches against those of the standard library.
#include "pfv/pores/lanes.hpp"

#include <gtest/gtest.h>

using namespace pfv;

namespace {

TEST(Lanes, LogIsThatOfTheStandardLibrary) {
  for (double x = 1e-300; x < 1e300; x *= 1.00137)
    ASSERT_NEAR(lanes::log(x), std::log(x), 3e-16 * std::max(1.0, std::abs(std::log(x)))) << x;
  EXPECT_EQ(lanes::log(1), 0);
}

TEST(Lanes, ExpIsThatOfTheStandardLibrary) {
  for (double x = -700; x < 700; x += .00737)
    ASSERT_NEAR(lanes::exp(x) / std::exp(x), 1, 2e-15) << x;
  EXPECT_EQ(lanes::exp(0), 1);
}

TEST(Lanes, Atan2IsThatOfTheStandardLibrary) {
  for (double angle = -3.14; angle < 3.14; angle += .000737)
    ASSERT_NEAR(lanes::atan2(std::sin(angle), std::cos(angle)), angle, 2e-15) << angle;
  EXPECT_EQ(lanes::atan2(0, 0), 0);
}

} // namespace
