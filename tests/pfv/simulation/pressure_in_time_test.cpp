#include "scenes.hpp"

#include <gtest/gtest.h>

using namespace pfv;
using namespace pfv::testing;

namespace {

constexpr PressureInTime::Point start{0.01, 0}, top{0.05, 400}, end{0.06, 100};

/// With a floor whose pressure rises and falls.
Scene ramped(const TimeScheme& scheme) {
  Scene scene = drained_box(100, 1.35, 10);
  scene.scheme = scheme;
  scene.fluid->in_time[index(Face::z_min)] = {{start, top, end}};
  return scene;
}

TEST(PressureInTime, IsLinearBetweenItsPointsAndConstantBeyond) {
  const PressureInTime pressure{{start, top, end}};
  EXPECT_EQ(pressure.at(0), 0);
  EXPECT_DOUBLE_EQ(pressure.at(0.03), 200);
  EXPECT_EQ(pressure.at(0.05), 400);
  EXPECT_DOUBLE_EQ(pressure.at(0.055), 250);
  EXPECT_EQ(pressure.at(1), 100);
}

TEST(PressureInTime, OnFixedGrainsGivesTheSteadyFlowOfItsMoment) {
  for (const TimeScheme& scheme : {TimeScheme(Explicit{}), TimeScheme(SemiImplicit{})}) {
    Scene scene = ramped(scheme);
    scene.grains.density = 1e15;
    scene.grains.walls.motion[index(Face::z_max)] = FixedWall{};
    scene.step = 2e-3;
    scene.fluid->tolerance = 1e-10;
    Simulation simulation(scene);
    for (int n = 0; n < 40; ++n) {
      const double now = scene.fluid->in_time[index(Face::z_min)]->at(simulation.grains().time);
      simulation.advance();
      if (n % 8 != 7)
        continue;
      Scene steady = scene;
      steady.fluid->in_time = {};
      steady.fluid->faces[index(Face::z_min)] = Pressure{now};
      const Simulation alike(steady);
      ASSERT_GT(now, 0);
      for (std::size_t i = 0; i < alike.fluid()->pressure().size(); ++i)
        ASSERT_NEAR(simulation.fluid()->pressure()[i], alike.fluid()->pressure()[i], 1e-6 * now);
    }
    // What flows through fixed grains does so against friction alone.
    const EnergyBalance& energy = simulation.grains().energy;
    EXPECT_GT(energy.loads, 0);
    EXPECT_NEAR(energy.fluid / energy.loads, 1, 1e-6);
  }
}

TEST(PressureInTime, DoesWorkThatIsStoredOrLost) {
  for (const TimeScheme& scheme : {TimeScheme(Explicit{}), TimeScheme(SemiImplicit{})}) {
    Scene scene = ramped(scheme);
    scene.grains.walls.motion[index(Face::z_max)] = LoadedWall{100, 2600 * 0.5};
    scene.step = 0.1 * Simulation(scene).step();
    Simulation simulation(scene);
    EXPECT_NEAR(energy_balance(simulation, static_cast<int>(0.1 / *scene.step)), 1, 1e-3);
    const EnergyBalance& energy = simulation.grains().energy;
    EXPECT_GT(energy.loads, 2 * 100 * (1 - height(simulation))); // most is not of the piston
    EXPECT_GT(energy.fluid, 0);
  }
}

TEST(PressureInTime, OnBothEndsOnlyChangesTheLevel) {
  // Grains feel no uniform pressure, and a piston that drains feels it as a load.
  const auto settled = [](double pressure) {
    Scene scene = ramped(SemiImplicit{});
    scene.fluid->tolerance = 1e-10;
    scene.step = 1e-3;
    for (const Face face : {Face::z_min, Face::z_max})
      scene.fluid->in_time[index(face)] = {{{0, 0}, {0.02, pressure}}};
    scene.grains.walls.motion[index(Face::z_max)] = MovingWall{-0.05};
    Simulation simulation(scene);
    for (int n = 0; n < 100; ++n)
      simulation.advance();
    return simulation.grains().grains.packing.spheres;
  };
  const auto low = settled(0), high = settled(1000);
  for (std::size_t i = 0; i < low.size(); ++i)
    EXPECT_LT((low[i].centre - high[i].centre).norm(), 1e-9);
}

} // namespace
