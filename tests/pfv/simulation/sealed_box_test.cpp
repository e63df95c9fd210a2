// No face or point has a pressure: what a compressible fluid stores sets the level of its pressures.
#include "pfv/problem/error.hpp"
#include "scenes.hpp"

#include "support/message_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace pfv;
using namespace pfv::testing;

namespace {

constexpr double bulk_modulus = 1e5, per_step = 1e-5; // Pa; m by which the piston of fixed grains moves

Scene sealed(double ratio, const PeriodicAxes& periodic = {}) {
  Scene scene = drained_box(100, ratio, 10);
  scene.packing =
      random_packing({.spheres = 100, .solid_fraction = 0.5, .radius_ratio = ratio, .seed = 2, .periodic = periodic});
  scene.grains.walls.periodic = periodic;
  for (const Face face : all_faces)
    if (periodic[index(axis_of(face))])
      scene.fluid->faces[index(face)] = Periodic{};
    else
      scene.fluid->faces[index(face)] = SlipWall{};
  scene.fluid->compressible = CompressibleFluid{bulk_modulus};
  return scene;
}

/// Too heavy to be moved by anything, under a piston that moves down by `per_step` in a step.
Scene with_fixed_grains(Scene scene) {
  scene.grains.density = 1e15;
  scene.step = 1e-3;
  scene.grains.walls.motion[index(Face::z_max)] = MovingWall{-per_step / *scene.step};
  return scene;
}

double void_volume(const Simulation& simulation) {
  const auto& volume = simulation.fluid()->network().pores.void_volume;
  return std::reduce(volume.begin(), volume.end());
}

void advance(Simulation& simulation, int steps) {
  for (int n = 0; n < steps; ++n)
    simulation.advance();
}

TEST(SealedBox, PressureRisesByBulkModulusTimesTheVolumeTaken) {
  for (const PeriodicAxes& periodic : {PeriodicAxes{}, PeriodicAxes{true, true, false}})
    for (const TimeScheme& scheme : {TimeScheme(Explicit{}), TimeScheme(SemiImplicit{})}) {
      Scene scene = with_fixed_grains(sealed(1.35, periodic));
      scene.scheme = scheme;
      scene.fluid->refresh_drift = 1; // the pores stay as they are: the sum over them is that of the motion
      Simulation simulation(scene);
      EXPECT_EQ(simulation.fluid()->mean_pressure(), 0);
      const double hollow = void_volume(simulation);
      advance(simulation, 300); // the last ones change the pressure by less than the solver's tolerance
      EXPECT_NEAR(simulation.fluid()->mean_pressure() / (bulk_modulus * 300 * per_step / hollow), 1, 1e-8);
    }
}

TEST(SealedBox, KeepsItsFluidWhenPoresAreRenewed) {
  // dp = - K dV / V all the way, of a fluid that flows easily enough to be at one pressure: p = K ln(V_0 / V).
  for (const double rebuild_drift : {1.0, 2e-3}) {
    Scene scene = with_fixed_grains(sealed(3));
    scene.packing.box.upper.z() += 0.01; // the piston does not reach them
    scene.fluid->fluid.viscosity = 0.01;
    scene.fluid->refresh_drift = 1e-3;
    scene.fluid->rebuild_drift = rebuild_drift;
    Simulation simulation(scene);
    const double hollow = void_volume(simulation);
    advance(simulation, 300);
    const auto& fluid = *simulation.fluid();
    EXPECT_GT(rebuild_drift < 1 ? fluid.rebuilt : fluid.refreshed, 5u);
    const double left = hollow - 300 * per_step;
    EXPECT_NEAR(fluid.mean_pressure() / (bulk_modulus * std::log(hollow / left)), 1, 1e-3);
  }
}

TEST(SealedBox, ComesToOnePressureWhenThePistonStops) {
  Scene scene = with_fixed_grains(sealed(1.35));
  Simulation simulation(scene);
  advance(simulation, 20);
  const double mean = simulation.fluid()->mean_pressure();
  scene.grains.walls.motion[index(Face::z_max)] = FixedWall{};
  scene.step = 1;
  Simulation stopped(scene, simulation.checkpoint());
  advance(stopped, 20);
  const auto [least, most] = std::ranges::minmax_element(stopped.fluid()->pressure());
  EXPECT_NEAR(*least / mean, 1, 1e-5);
  EXPECT_NEAR(*most / mean, 1, 1e-5);
  EXPECT_NEAR(stopped.fluid()->mean_pressure() / mean, 1, 1e-9);
}

TEST(SealedBox, SharesALoadBetweenFluidAndSkeletonAndKeepsEnergy) {
  for (const TimeScheme& scheme : {TimeScheme(Explicit{}), TimeScheme(SemiImplicit{})}) {
    Scene scene = sealed(1.35);
    scene.scheme = scheme;
    scene.fluid->compressible = CompressibleFluid{1e7}; // against 1e6 of the grains
    scene.grains.damping.share = 0.3;
    scene.step = 0.1 * Simulation(scene).step();
    Simulation simulation(scene);
    EXPECT_NEAR(energy_balance(simulation, 6000), 1, 1e-3);
    EXPECT_GT(simulation.fluid()->mean_pressure(), 500); // of the 1000 Pa on the piston
    EXPECT_LT(simulation.fluid()->mean_pressure(), 1100);
  }
}

TEST(SealedBox, TakesTheWorkOfAWallThatMoves) {
  Scene scene = sealed(1.35);
  scene.fluid->compressible = CompressibleFluid{1e7};
  scene.grains.walls.motion[index(Face::z_max)] = MovingWall{-0.01};
  scene.step = 0.1 * Simulation(scene).step();
  Simulation simulation(scene);
  const double hollow = void_volume(simulation);
  EXPECT_NEAR(energy_balance(simulation, 3000), 1, 1e-3);
  const double rise = simulation.fluid()->mean_pressure(), taken = 1 - height(simulation);
  EXPECT_NEAR(simulation.grains().energy.fluid / (0.5 * rise * taken), 1,
              0.02); // of a spring, and what flow dissipates
  EXPECT_NEAR(rise / (1e7 * taken / hollow), 1, 0.02);
}

TEST(SealedBox, IsStableAtItsOwnExplicitStep) {
  for (const double stiffness : {1e4, 1e9}) {
    Scene scene = sealed(1.35);
    scene.fluid->compressible = CompressibleFluid{stiffness};
    Simulation simulation(scene);
    for (int n = 0; n < 2000; ++n) {
      simulation.advance();
      ASSERT_LE(kinetic_energy(simulation.grains().grains, scene.grains.walls),
                1.001 * simulation.grains().energy.loads);
    }
  }
}

TEST(SealedBox, OfAnIncompressibleFluidIsRefusedInOneLine) {
  Scene scene = sealed(1.35);
  scene.fluid->compressible.reset();
  const std::string line = message_of<InputError>([&] { Simulation{scene}; });
  EXPECT_NE(line.find("must have a pressure, or the fluid be compressible"), std::string::npos) << line;
  EXPECT_EQ(line.find('\n'), std::string::npos) << line;
}

} // namespace
