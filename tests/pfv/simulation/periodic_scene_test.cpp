#include "pfv/problem/error.hpp"
#include "pfv/simulation/relax.hpp"
#include "scenes.hpp"

#include <gtest/gtest.h>

#include <numeric>

using namespace pfv;
using namespace pfv::testing;

namespace {

constexpr PeriodicAxes sideways{true, true, false};

Scene periodic_box(int grains) {
  Scene scene = drained_box(grains, 1.35, 10);
  scene.packing =
      random_packing({.spheres = grains, .solid_fraction = 0.5, .radius_ratio = 1.35, .seed = 2, .periodic = sideways});
  scene.grains.walls.periodic = sideways;
  for (const Face face : {Face::x_min, Face::x_max, Face::y_min, Face::y_max})
    scene.fluid->faces[index(face)] = Periodic{};
  return scene;
}

TEST(PeriodicScene, FluxSumsToWhatWallsSweepAndUniformPressurePushesNoGrain) {
  Clock clock;
  const Scene scene = periodic_box(200);
  const PoreNetwork network = build_pore_network(scene.packing, sideways, clock);
  const SolidFlux flux = solid_flux(network, MirrorWalls{});
  std::vector<Vec3> force;
  pressure_forces(flux, std::vector<double>(flux.pores(), 1.0), force);
  for (std::size_t k = 0; k + 6 < flux.bodies; ++k)
    EXPECT_LT(force[k].norm(), 1e-13);
  EXPECT_NEAR(force[flux.bodies - 1].z(), 1, 1e-12);
  std::vector<Vec3> velocity(flux.bodies, Vec3::Zero());
  for (std::size_t k = 0; k < flux.bodies; ++k)
    velocity[k] = {std::sin(1.0 + k), std::sin(2.0 + 3 * k), std::sin(3.0 + 7 * k)};
  velocity[flux.bodies - 2] = {0, 0, -0.5};
  velocity[flux.bodies - 1] = {0, 0, 2};
  std::vector<double> rate;
  volume_rates(flux, velocity, rate);
  EXPECT_NEAR(std::reduce(rate.begin(), rate.end()), 2.5, 1e-12);
}

TEST(PeriodicScene, DoesNotDependOnWhereTheBoxIsCut) {
  Scene scene = periodic_box(200);
  scene.fluid->tolerance = 1e-10;
  scene.grains.damping.share = 0.2;
  scene.step = Simulation(scene).step();
  const auto height_after = [&](const Vec3& shift) {
    Scene shifted = scene;
    for (Sphere& sphere : shifted.packing.spheres)
      for (int axis = 0; axis < 2; ++axis) {
        double& x = sphere.centre[axis];
        x += shift[axis];
        x -= std::floor(x);
      }
    Simulation simulation(shifted);
    for (int n = 0; n < 300; ++n)
      simulation.advance();
    EXPECT_GT(simulation.fluid()->refreshed + simulation.fluid()->rebuilt, 0u);
    return 1 - height(simulation);
  };
  const double settled = height_after(Vec3::Zero());
  EXPECT_GT(settled, 1e-4);
  EXPECT_NEAR(height_after(Vec3(0.37, 0.81, 0)) / settled, 1, 1e-5);
}

TEST(PeriodicScene, EnergyIsKeptAcrossTheBox) {
  Scene scene = periodic_box(150);
  scene.step = 0.1 * Simulation(scene).step();
  Simulation simulation(scene);
  const double balance = energy_balance(simulation, 3000);
  EXPECT_NEAR(balance, 1, 1e-3);
}

TEST(PeriodicScene, NeedsFluidAndGrainsToRepeatAlike) {
  Scene scene = periodic_box(50);
  scene.fluid->faces[index(Face::x_min)] = scene.fluid->faces[index(Face::x_max)] = SlipWall{};
  EXPECT_THROW(Simulation{scene}, InputError);
}

TEST(Relax, SettlesUnderAStressAndCarriesIt) {
  Scene scene = periodic_box(100);
  scene.grains.damping.share = 0.3;
  GrainCycle cycle(scene.packing, scene.grains);
  Clock clock;
  const std::size_t steps = relax(cycle, {1e-4, 1e-3}, clock);
  EXPECT_GT(steps, 0u);
  EXPECT_LE(cycle.unbalanced_force(), 1e-4);
  EXPECT_NEAR(contact_stress(cycle.grains, cycle.contacts)(2, 2) / -1000, 1, 0.02);
  EXPECT_THROW(relax(cycle, {1e-18, 1e-3, 400}, clock), SolveError);
}

TEST(Relax, GoesOnUnderAnotherSceneWithItsSprings) {
  Scene scene = periodic_box(100);
  scene.grains.damping.share = 0.3;
  GrainCycle cycle(scene.packing, scene.grains);
  Clock clock;
  relax(cycle, {1e-5, 1e-4}, clock);
  const double height_before = cycle.grains.packing.box.size().z();
  Simulation goes_on(scene, cycle);
  for (int n = 0; n < 200; ++n)
    goes_on.advance();
  EXPECT_NEAR(height(goes_on) / height_before, 1, 1e-5);
}

} // namespace
