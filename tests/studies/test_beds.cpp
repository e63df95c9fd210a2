#include "studies/document/markdown.hpp"
#include "studies/motion/immersed_settling.hpp"
#include "studies/motion/uplift.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace studies {
namespace {

const Say silent = [](const std::string&, double) {};

// Few grains: the machinery, not the accuracy.

TEST(ImmersedSettling, FluidAndFloorCarryTheWeightAndTheFloorAllOfItInTheEnd) {
  Bed bed;
  bed.grains = 80;
  bed.young = 1e5; // longer steps
  bed.lubricated = true;
  const Settling test = settle(bed, 0.3, silent);
  ASSERT_GT(test.moments.size(), 20u);
  const auto highest = std::ranges::max(test.moments, {}, &SettlingMoment::floor_pressure);
  EXPECT_NEAR(highest.floor_pressure, 1, 0.2); // films hold some grains at the floor at once
  EXPECT_LT(highest.time, 0.2 * test.moments.back().time);
  for (std::size_t n = test.moments.size() / 4; n < test.moments.size(); ++n)
    EXPECT_NEAR(test.moments[n].lift + test.moments[n].on_floor, 1, 0.05) << test.moments[n].time;
  EXPECT_LT(test.moments.back().floor_pressure, 0.1);
  EXPECT_GT(test.bed_porosity, 0.35);
  EXPECT_LT(test.bed_porosity, 0.65);
  EXPECT_NE(to_markdown(settling_report(test).page).find("buoyant weight"), std::string::npos);
}

TEST(Uplift, LeavesTheFloorNearTheCriticalGradient) {
  Bed bed;
  bed.grains = 150;
  const Uplift test = lift_up(bed, silent);
  EXPECT_NEAR(test.critical, (1 - test.porosity) * 1.6, 1e-12);
  EXPECT_NEAR(test.carried_at / test.critical, 1, 0.1);
  EXPECT_NEAR(test.risen_at / test.critical, 1, 0.1);
  for (const UpliftMoment& moment : test.moments)
    if (moment.rise < 0.01) {
      EXPECT_NEAR(moment.lift + moment.on_floor, 1, 0.05);
    }
  EXPECT_GT(test.moments.back().rise, 0.01);
}

TEST(Experiments, TellTheirQuestionAndTheOutcomeOfEveryExpectation) {
  const Expectation expectations[] = {within("one", -0.02, 0.03), within("other", 0.04, 0.03)};
  EXPECT_FALSE(all_hold(expectations));
  EXPECT_TRUE(all_hold(std::span(expectations).first(1)));
  const Document page = page_of(uplift_experiment, expectations);
  EXPECT_EQ(outcome_of(page), "1 of 2 expectations hold.");
  const std::string text = to_markdown(page);
  EXPECT_NE(text.find(uplift_experiment.question), text.npos);
  EXPECT_NE(text.find("- *holds*: one: -2 %, to be within 3 %.\n- *does not hold*: other: 4 %"), text.npos) << text;
}

} // namespace
} // namespace studies
