#include "studies/document/markdown.hpp"
#include "studies/motion/consolidation.hpp"
#include "studies/motion/line_fit.hpp"
#include "studies/motion/terzaghi.hpp"

#include <gtest/gtest.h>

namespace studies {
namespace {

TEST(Terzaghi, HasTheTabulatedValues) {
  EXPECT_NEAR(terzaghi_settlement(0.25), 0.56223, 1e-5);
  EXPECT_NEAR(terzaghi_settlement(0.5), 0.76395, 1e-5);
  EXPECT_NEAR(terzaghi_settlement(0.75), 0.87262, 1e-5);
  EXPECT_NEAR(terzaghi_settlement(0.19673), 0.5, 1e-5);
  EXPECT_NEAR(terzaghi_pressure(0.25, 1), 0.68545, 1e-5);
  EXPECT_NEAR(terzaghi_pressure(0.5, 1), 0.37078, 1e-5);
  EXPECT_NEAR(terzaghi_pressure(0.75, 1), 0.20009, 1e-5);
  EXPECT_NEAR(terzaghi_settlement(1e-4), std::sqrt(4e-4 / std::numbers::pi), 1e-7);
  EXPECT_EQ(terzaghi_settlement(0), 0);
  EXPECT_EQ(terzaghi_pressure(0, 1), 1);
  EXPECT_NEAR(terzaghi_pressure(0.3, 0), 0, 1e-12);
}

TEST(LineFit, FindsALineThroughWeightedPoints) {
  LineFit line;
  for (const double x : {0.0, 1.0, 4.0})
    line.add(x, 2 - 0.5 * x, 1 + x);
  line.add(3, 100, 0);
  EXPECT_NEAR(line.slope(), -0.5, 1e-14);
  EXPECT_NEAR(line.at(10), -3, 1e-13);
  EXPECT_NEAR(line.where(0), 4, 1e-13);
}

TEST(Consolidation, ErrorIsThatOfTheMomentsBetweenTheTwoTimes) {
  Consolidation test;
  test.layer.share_of_ends = 0.1;
  const auto moment = [&](double t, double settlement, double pressure) {
    test.moments.push_back(
        {t, expected_settlement(test.layer, t) + settlement, expected_pressure(test.layer, t, 0.5) + pressure, {}});
  };
  moment(0.01, 0.5, 0.5);
  moment(0.05, 0.03, 0);
  moment(1, 0.01, -0.04);
  const ConsolidationError error = error_of(test);
  EXPECT_NEAR(error.largest_settlement, 0.03, 1e-12);
  EXPECT_NEAR(error.largest_pressure, 0.04, 1e-12);
  EXPECT_NEAR(error.rms_settlement, std::sqrt(0.001 / 2), 1e-12);
}

/// Few grains and a short test: the machinery, not the accuracy.
TEST(Consolidation, OfASmallLayerKeepsItsEnergyAndComesNearTerzaghi) {
  Oedometer asked;
  asked.grains = 250;
  asked.duration = 0.25;
  const Consolidation test = consolidate(asked, {0.1, 0.3}, [](const std::string&, double) {});
  EXPECT_LT(std::abs(test.energy_error), 1e-3);
  EXPECT_LT(std::abs(test.layer.nonlinearity), 0.02);
  EXPECT_GT(test.layer.lower, 0);
  EXPECT_LT(test.layer.upper, 1);
  for (const Moment& moment : test.moments) {
    EXPECT_NEAR(moment.settlement, expected_settlement(test.layer, moment.time_factor), 0.1);
    EXPECT_NEAR(moment.middle_pressure, expected_pressure(test.layer, moment.time_factor, 0.5), 0.12);
  }
  const ExperimentReport report = consolidation_report(test, asked);
  EXPECT_NE(to_markdown(report.page).find("c_v"), std::string::npos);
  // Another layer that is further off is what counts.
  const OtherLayer other{7, {0.5, 0.1, 0, 0}};
  const ExperimentReport both = consolidation_report(test, asked, std::span(&other, 1));
  EXPECT_FALSE(both.holds);
  EXPECT_NE(to_markdown(both.page).find("| 7 | 50 %"), std::string::npos);
}

} // namespace
} // namespace studies
