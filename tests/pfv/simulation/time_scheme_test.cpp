#include "pfv/problem/error.hpp"
#include "scenes.hpp"

#include <gtest/gtest.h>

using namespace pfv;
using namespace pfv::testing;

namespace {

TEST(TimeScheme, ExplicitIsStableJustBelowTheViscousLimitAndNotJustAbove) {
  for (const double ratio : {1.35, 5.0}) {
    Scene scene = drained_box(150, ratio, 300);
    scene.fluid->refresh_drift = 1; // so that the limit stays what it is
    const StepLimits limits = Simulation(scene).limits();
    ASSERT_LT(*limits.viscous, 0.2 * limits.contact);
    for (const double share : {0.97, 1.03}) {
      scene.step = share * (share < 1 ? limits.joint() : *limits.viscous);
      Simulation simulation(scene);
      // Dissipation outgrows the work of the load a thousand times only when the step itself puts energy in.
      bool grown = false;
      try {
        for (int n = 0; n < 3000 && !grown; ++n) {
          simulation.advance();
          const double work = std::max(1e-6, simulation.grains().energy.loads);
          grown = kinetic_energy(simulation.grains().grains, scene.grains.walls) > 1000 * work;
        }
      } catch (const SolveError& error) {
        grown = std::string(error.what()).find("of the fluid") != std::string::npos;
      }
      EXPECT_EQ(grown, share > 1) << ratio << " " << share;
    }
  }
}

TEST(TimeScheme, LeavingStabilityEndsInAMessageThatNamesTheLimits) {
  Scene scene = drained_box(100, 1.35, 300);
  scene.step = 3 * *Simulation(scene).limits().viscous;
  Simulation simulation(scene);
  std::string message;
  try {
    for (int n = 0; n < 2000; ++n)
      simulation.advance();
  } catch (const SolveError& error) {
    message = error.what();
  }
  EXPECT_NE(message.find("left stability"), std::string::npos) << message;
  EXPECT_NE(message.find("s of the fluid"), std::string::npos) << message;
}

TEST(TimeScheme, SemiImplicitSettlesAlikeFarBeyondTheViscousLimit) {
  Scene scene = drained_box(150, 1.35, 6000);
  scene.grains.damping.share = 0.2;
  const StepLimits limits = Simulation(scene).limits();
  ASSERT_LT(100 * *limits.viscous, 0.31 * limits.contact);
  const double until = 10000 * *limits.viscous;
  const auto settled = [&](double step, TimeScheme scheme) {
    scene.step = step;
    scene.scheme = scheme;
    Simulation simulation(scene);
    const auto steps = static_cast<int>(until / step + 0.5);
    for (int n = 0; n < steps; ++n)
      simulation.advance();
    return 1 - height(simulation);
  };
  const double reference = settled(0.8 * *limits.viscous, Explicit{});
  EXPECT_GT(reference, 0);
  EXPECT_NEAR(settled(20 * *limits.viscous, SemiImplicit{}) / reference, 1, 0.01);
  EXPECT_NEAR(settled(100 * *limits.viscous, SemiImplicit{}) / reference, 1, 0.02);
}

TEST(TimeScheme, NoticesGrainsThatAreNowhere) {
  Scene scene;
  scene.packing.spheres = {{{.5, .5, .5}, .2}, {{.5, .5, .5}, .1}}; // about one centre, so without a normal
  Simulation simulation(scene);
  const auto run = [&] {
    for (int n = 0; n < 20; ++n)
      simulation.advance();
  };
  EXPECT_THROW(run(), SolveError);
}

} // namespace
