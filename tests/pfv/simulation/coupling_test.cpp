#include "pfv/problem/error.hpp"
#include "scenes.hpp"

#include "support/message_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using namespace pfv;
using namespace pfv::testing;

namespace {

std::vector<std::string> stages_of(const Simulation& simulation) {
  std::vector<std::string> names;
  for (const Stage& stage : simulation.clock().stages())
    names.push_back(stage.name);
  return names;
}

TEST(Coupling, DrySceneHasNeitherPoresNorStagesOfAFlow) {
  Scene scene = drained_box(100, 1.35, 1);
  scene.fluid.reset();
  Simulation simulation(scene);
  for (int n = 0; n < 50; ++n)
    simulation.advance();
  EXPECT_EQ(stages_of(simulation), (std::vector<std::string>{"contacts", "motion"}));
  EXPECT_FALSE(simulation.fluid());
  EXPECT_TRUE(simulation.fluid_forces().empty());
  EXPECT_TRUE(simulation.grains().weight.empty());
  EXPECT_FALSE(simulation.limits().viscous);
  EXPECT_FALSE(simulation.limits().lubrication);
  EXPECT_FALSE(simulation.grains().films);
}

TEST(Coupling, WorkOfLoadsIsStoredOrLostToTheFluidAndFriction) {
  for (const double ratio : {1.0, 5.0}) {
    Scene scene = drained_box(150, ratio, 10);
    scene.grains.damping.share = 0.1;
    scene.step = 0.1 * Simulation(scene).step();
    Simulation simulation(scene);
    const double balance = energy_balance(simulation, 4000);
    EXPECT_GT(simulation.grains().energy.fluid, 0.1 * simulation.grains().energy.loads);
    EXPECT_NEAR(balance, 1, 1e-3) << ratio;
  }
}

TEST(Coupling, LubricatedSceneWithoutAFlowHasNoPores) {
  Scene scene = drained_box(100, 1.35, 1);
  scene.fluid.reset();
  scene.grains.lubrication = Lubrication{1};
  Simulation simulation(scene);
  for (int n = 0; n < 50; ++n)
    simulation.advance();
  EXPECT_EQ(stages_of(simulation), (std::vector<std::string>{"contacts", "lubrication", "motion"}));
  EXPECT_GT(simulation.grains().energy.lubrication, 0);
  EXPECT_LT(simulation.step(), 0.8 * *simulation.limits().lubrication);
  EXPECT_FALSE(simulation.limits().viscous);
}

TEST(Coupling, FilmsAndPoresTakeTheWorkOfLoadsTogether) {
  for (const TimeScheme& scheme : {TimeScheme(Explicit{}), TimeScheme(SemiImplicit{})}) {
    Scene scene = drained_box(150, 1.35, 10);
    scene.grains.lubrication = Lubrication{10};
    scene.scheme = scheme;
    scene.step = 0.1 * Simulation(scene).step();
    Simulation simulation(scene);
    const double balance = energy_balance(simulation, 4000);
    EXPECT_GT(simulation.grains().energy.lubrication, 0.01 * simulation.grains().energy.loads);
    EXPECT_GT(simulation.grains().energy.fluid, 0.01 * simulation.grains().energy.loads);
    EXPECT_NEAR(balance, 1, 1e-3);
  }
}

TEST(Coupling, LubricatedSceneIsStableAtItsOwnStep) {
  for (const double viscosity : {0.1, 1000.0}) {
    Scene scene = drained_box(80, 3, viscosity);
    scene.grains.lubrication = Lubrication{viscosity};
    scene.scheme = SemiImplicit{};
    Simulation simulation(scene);
    double highest = 0;
    for (int n = 0; n < 2000; ++n) {
      simulation.advance();
      highest = std::max(highest, kinetic_energy(simulation.grains().grains, scene.grains.walls));
      EXPECT_LE(kinetic_energy(simulation.grains().grains, scene.grains.walls), simulation.grains().energy.loads);
    }
    EXPECT_GT(highest, 0);
    EXPECT_GE(simulation.grains().energy.lubrication, 0);
  }
}

TEST(Coupling, LongStepOfStiffFilmsEndsInAMessageThatNamesThem) {
  Scene scene = drained_box(100, 1.35, 1);
  scene.fluid.reset();
  scene.grains.lubrication = Lubrication{1000};
  scene.step = 3 * *Simulation(scene).limits().lubrication;
  Simulation simulation(scene);
  const std::string message = message_of<SolveError>([&] {
    for (int n = 0; n < 3000; ++n)
      simulation.advance();
  });
  EXPECT_NE(message.find("left stability"), std::string::npos) << message;
  EXPECT_NE(message.find("s of the lubrication"), std::string::npos) << message;
}

TEST(Coupling, FollowedPoresPushAsNewOnes) {
  Scene scene = drained_box(150, 2, 10);
  scene.fluid->tolerance = 1e-10;
  scene.fluid->refresh_drift = 1e-3;
  Clock clock;
  Packing packing = scene.packing;
  PoreFluid followed(*scene.fluid, packing, clock);
  for (std::size_t k = 0; k < packing.spheres.size(); ++k)
    packing.spheres[k].centre += 0.003 * packing.spheres[k].radius * Vec3(std::sin(k), std::cos(k), std::sin(3.0 * k));
  packing.box.upper.z() += 1e-4;
  followed.follow(packing, clock);
  EXPECT_EQ(followed.refreshed + followed.rebuilt, 1u);
  PoreFluid fresh(*scene.fluid, packing, clock);
  std::vector<Vec3> velocity(packing.spheres.size() + 6, Vec3::Zero());
  for (std::size_t k = 0; k < packing.spheres.size(); ++k)
    velocity[k] = {std::sin(1.0 + k), std::cos(2.0 * k), std::sin(5.0 * k)};
  const auto a = followed.forces(velocity, {}, 1, clock), b = fresh.forces(velocity, {}, 1, clock);
  double difference = 0, size = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    difference += (a[k] - b[k]).squaredNorm();
    size += b[k].squaredNorm();
  }
  EXPECT_LT(std::sqrt(difference / size), 1e-6);
}

TEST(Coupling, CompressibleFluidTakesTheLoadAtOnceInProportionToItsStiffness) {
  // Sealed box: fluid and skeleton share the piston's stress; a stiff fluid carries nearly all of it.
  for (const double bulk_modulus : {1e6, 1e8}) {
    Scene scene = drained_box(150, 1.35, 1);
    scene.fluid->faces = {};
    scene.fluid->faces[index(Face::z_min)] = Pressure{0};
    scene.fluid->compressible = CompressibleFluid{bulk_modulus};
    scene.scheme = SemiImplicit{};
    scene.grains.walls.motion[index(Face::z_max)] = MovingWall{-1e-3};
    Simulation simulation(scene);
    simulation.advance();
    const auto& fluid = *simulation.fluid();
    const double highest = *std::ranges::max_element(fluid.pressure());
    EXPECT_GT(highest, 0);
    // No pore can be pressed faster than by all of the volume the wall sweeps entering it.
    const double swept = 1e-3 * simulation.step();
    const double smallest = *std::ranges::min_element(fluid.network().pores.void_volume);
    EXPECT_LT(highest, bulk_modulus * swept / smallest);
  }
}

TEST(Coupling, SealedIncompressibleFluidIsRefused) {
  Scene scene = drained_box(100, 1, 1);
  scene.fluid->faces = {};
  EXPECT_NE(message_of<InputError>([&] { Simulation{scene}; }).find("pressure"), std::string::npos);
}

TEST(Coupling, UpwardFlowCarriesTheBuoyantWeight) {
  // The fluid's forces on grains and the face below them are the drop times the area, whatever the grains do.
  Scene scene = drained_box(100, 1.35, 1);
  scene.fluid->faces[index(Face::z_min)] = Pressure{500};
  scene.grains.walls.motion[index(Face::z_max)] = FixedWall{};
  scene.grains.forces = {Gravity{Vec3(0, 0, -9.81)}};
  scene.grains.forces.push_back(BuoyancyOfGrains{{1000, Vec3(0, 0, -9.81)}});
  Simulation simulation(scene);
  double weight = 0, up = 0;
  simulation.advance();
  for (std::size_t k = 0; k < simulation.grains().grains.size(); ++k) {
    weight += simulation.grains().weight[k].z();
    up += simulation.fluid_forces()[k].z();
  }
  EXPECT_NEAR(weight, -0.5 * 1600 * 9.81, 1e-9);
  EXPECT_NEAR(up, 500, 1);
}

} // namespace
