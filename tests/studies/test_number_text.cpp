#include "studies/runner/number_text.hpp"

#include "studies/runner/cost.hpp"
#include "studies/runner/progress.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include <cmath>

namespace {

TEST(NumberText, ShowsAsManyDigitsAsTheErrorLeaves) {
  EXPECT_EQ(studies::with_error(1.23456, 0.012), "1.235 ± 0.012");
  EXPECT_EQ(studies::with_error(0.00123456, 0.0000012), "(1.2346 ± 0.0012)e-3");
  EXPECT_EQ(studies::with_error(0.00123456, std::nullopt), "1.235e-3");
  EXPECT_EQ(studies::with_error(std::nan(""), 1.0), "n.a.");
}

TEST(NumberText, ShowsTheRangeOfTheTable) {
  EXPECT_EQ(studies::count(45), "45");
  EXPECT_EQ(studies::count(1.2e6), "1.2e6");
  EXPECT_EQ(studies::seconds(0.00022), "0.00022");
  EXPECT_EQ(studies::seconds(2.21), "2.2");
  EXPECT_EQ(studies::seconds(5400), "5400");
  EXPECT_EQ(studies::bytes(45e6), "45 MB");
  EXPECT_EQ(studies::bytes(2.1e9), "2.1 GB");
  EXPECT_EQ(studies::percent(-0.456), "-46 %");
}

TEST(Cost, EveryStageIsCountedOnce) {
  const studies::Cost split =
      studies::cost({{"mesh", 1}, {"triangulate", 2}, {"assemble", 4}, {"factor", 8}, {"solve", 16}, {"forces", 32}});
  EXPECT_EQ(split, (studies::Cost{1, 14, 48}));
  EXPECT_EQ(split.total(), 63);
}

TEST(Cost, ARepeatedStepIsBesideTheTotal) {
  const studies::Cost split = studies::cost({{"solve", 1}, {"repeat: geometry", 2}, {"repeat: solve", 4}});
  EXPECT_EQ(split, (studies::Cost{0, 0, 1, 6}));
  EXPECT_EQ(split.total(), 1);
}

TEST(ProgressBar, FillsUpAndStaysFull) {
  const std::string half = studies::progress_bar(5, 10, 80);
  EXPECT_EQ(std::ranges::count(half, '#'), std::ranges::count(half, '.'));
  EXPECT_EQ(std::ranges::count(studies::progress_bar(100, 10, 80), '.'), 0);
  EXPECT_LE(studies::progress_bar(5, 10, 40).size(), 40U);
}

} // namespace
