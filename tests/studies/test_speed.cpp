#include "studies/motion/liggghts.hpp"
#include "studies/motion/speed.hpp"

#include "pfv/problem/error.hpp"
#include "studies/document/markdown.hpp"

#include <gtest/gtest.h>

using namespace studies;

namespace {

const Say quietly = [](const std::string&, double) {};

TEST(Speed, OfDryGrainsIsMeasuredTurnByTurn) {
  const auto list = dry_speeds(1000, 40, 2, quietly);
  ASSERT_EQ(list.size(), 2u);
  for (const DrySpeed& one : list) {
    EXPECT_GT(one.contacts, 2000u);
    EXPECT_EQ(one.ours.cpu_seconds.size(), 2u);
    EXPECT_GT(one.ours.median(), 0);
    EXPECT_GT(one.our_energy, 0);
    EXPECT_EQ(one.theirs.has_value(), !missing_liggghts().has_value());
    if (one.theirs) { // the same springs, friction and walls: what differs is half a step between velocities and places
      EXPECT_NEAR(one.our_energy / one.their_energy, 1, 0.1) << one.law;
    }
  }
}

TEST(Speed, LiggghtsHasNoSpringsInProportionToTheGrain) {
  EXPECT_THROW(run_liggghts({}, pfv::LinearSprings{}, 2600, 1e-6, 1, 1), pfv::InputError);
}

TEST(Speed, IsReportedWithoutPeersToo) {
  Speed speed;
  DrySpeed dry;
  dry.law = "constant";
  dry.ours = Turns{{1e-3}};
  speed.dry.push_back(dry);
  speed.coupled.ours = speed.coupled.at_our_step = Turns{{1e-2}};
  speed.coupled.steps = 4;
  speed.coupled.counts = {1, 0, 8, 4};
  speed.scheme.lagging.cpu_seconds = 12;
  speed.scheme.implicit.cpu_seconds = 2;
  const ExperimentReport report = speed_report(speed);
  EXPECT_TRUE(report.holds);
  const std::string text = to_markdown(report.page);
  EXPECT_NE(text.find("unavailable"), std::string::npos);
  EXPECT_NE(text.find("2.00 iterations"), std::string::npos);
}

TEST(Speed, MedianIsThatOfTheTurns) {
  EXPECT_EQ((Turns{{3, 1, 2}}).median(), 2);
}

} // namespace
