// A run that is saved and one that goes on from the file are the same from there on, to the last bit.
#include "pfv/problem/error.hpp"
#include "scenes.hpp"

#include "support/message_of.hpp"
#include "support/temporary_file.hpp"

#include <gtest/gtest.h>

using namespace pfv;
using namespace pfv::testing;

namespace {

void advance(Simulation& simulation, int steps) {
  for (int n = 0; n < steps; ++n)
    simulation.advance();
}

/// Both are saved once more before they are compared, so that all they remember is.
void expect_to_go_on_alike(const Scene& scene, int steps) {
  const TemporaryFile file("run.checkpoint", "");
  Simulation first(scene);
  advance(first, steps);
  write_checkpoint(file.path(), first.checkpoint());
  Simulation second(scene, read_checkpoint(file.path()));
  ASSERT_EQ(second.steps(), first.steps());
  EXPECT_EQ(second.step(), first.step());
  advance(first, steps);
  advance(second, steps);

  const GrainCycle &a = first.grains(), &b = second.grains();
  EXPECT_EQ(a.grains.packing, b.grains.packing);
  EXPECT_EQ(a.grains.velocity, b.grains.velocity);
  EXPECT_EQ(a.grains.wall_velocity, b.grains.wall_velocity);
  EXPECT_EQ(a.grains.number, b.grains.number);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.broken_bonds, b.broken_bonds);
  EXPECT_EQ(a.energy.friction, b.energy.friction);
  EXPECT_EQ(a.unbalanced_force(), b.unbalanced_force());
  ASSERT_EQ(first.fluid().has_value(), second.fluid().has_value());
  if (first.fluid()) {
    EXPECT_EQ(first.fluid()->pressure(), second.fluid()->pressure());
    EXPECT_EQ(first.fluid()->iterations, second.fluid()->iterations);
    EXPECT_EQ(first.fluid()->rebuilt, second.fluid()->rebuilt);
    EXPECT_GT(first.fluid()->refreshed + first.fluid()->rebuilt, 0u);
  }
  EXPECT_TRUE(to_bytes(first.checkpoint()) == to_bytes(second.checkpoint()));
}

/// Grains that fall on one another, rub and turn, with a wall that pushes them and one that a stress holds.
Scene dry() {
  Scene scene = drained_box(60, 2, 1);
  scene.fluid.reset();
  scene.grains.law = LinearSprings{1e6, 0.5, {0.5, 0.1}};
  scene.grains.forces = {Gravity{Vec3(0, 0, -9.81)}};
  scene.grains.damping.share = 0.2;
  scene.grains.walls.friction = 0.3;
  scene.grains.walls.motion[index(Face::x_min)] = MovingWall{0.02};
  return scene;
}

TEST(Checkpoint, GrainsGoOnBitForBit) {
  expect_to_go_on_alike(dry(), 1200); // the step is chosen anew every thousand
}

TEST(Checkpoint, BondsGoOnBitForBit) {
  Scene scene = dry();
  scene.packing = lattice_packing(Lattice::simple_cubic, touching_solid_fraction(Lattice::simple_cubic), 4);
  for (Sphere& sphere : scene.packing.spheres)
    sphere.radius *= 1.001;
  scene.grains.cohesion = Cohesion{100, 100};
  constexpr int steps = 40;
  scene.grains.forces = {Gravity{Vec3(3, 0, -9.81)}};
  Simulation some_break(scene);
  advance(some_break, steps);
  const std::size_t broken = some_break.grains().broken_bonds;
  EXPECT_GT(broken, 0u);
  advance(some_break, steps);
  EXPECT_GT(some_break.grains().broken_bonds, broken);
  expect_to_go_on_alike(scene, steps);
}

TEST(Checkpoint, FilmsGoOnBitForBit) {
  Scene scene = dry();
  scene.grains.lubrication = Lubrication{1};
  expect_to_go_on_alike(scene, 300);
}

TEST(Checkpoint, PeriodicGrainsGoOnBitForBit) {
  Scene scene = dry();
  scene.grains.walls.periodic = {false, true, false};
  scene.packing = random_packing(
      {.spheres = 60, .solid_fraction = 0.5, .radius_ratio = 2, .seed = 2, .periodic = {false, true, false}});
  expect_to_go_on_alike(scene, 300);
}

TEST(Checkpoint, AnExplicitFluidGoesOnBitForBit) {
  Scene scene = drained_box(60, 2, 20);
  scene.grains.walls.motion[index(Face::x_min)] = MovingWall{0.1};
  scene.fluid->refresh_drift = 1e-4; // so that pores are renewed and triangulated in a short run
  scene.fluid->rebuild_drift = 1e-2;
  expect_to_go_on_alike(scene, 50);
}

TEST(Checkpoint, ASemiImplicitFluidGoesOnBitForBit) {
  Scene scene = drained_box(60, 2, 1e3);
  scene.scheme = SemiImplicit{};
  scene.grains.walls.motion[index(Face::x_min)] = MovingWall{0.1};
  scene.fluid->faces[index(Face::z_min)] = Pressure{50};
  scene.fluid->refresh_drift = 1e-4;
  scene.fluid->rebuild_drift = 1e-2;
  expect_to_go_on_alike(scene, 50);
}

TEST(Checkpoint, ACompressibleFluidInAPeriodicBoxGoesOnBitForBit) {
  Scene scene = drained_box(60, 1.5, 1e3);
  const PeriodicAxes axes{true, false, false};
  scene.scheme = SemiImplicit{};
  scene.packing =
      random_packing({.spheres = 60, .solid_fraction = 0.5, .radius_ratio = 1.5, .seed = 2, .periodic = axes});
  scene.grains.walls.periodic = axes;
  scene.fluid->compressible = CompressibleFluid{1e5};
  scene.fluid->faces[index(Face::x_min)] = scene.fluid->faces[index(Face::x_max)] = Periodic{};
  scene.fluid->refresh_drift = 1e-4;
  scene.fluid->rebuild_drift = 1e-2;
  expect_to_go_on_alike(scene, 50);
}

TEST(Checkpoint, GrowingGrainsGoOnBitForBit) {
  Scene scene = dry();
  scene.grains.walls.motion = {};
  scene.grains.growth = Growth{0.5, 5e4};
  Simulation simulation(scene);
  advance(simulation, 2400);
  EXPECT_GT(simulation.grains().grains.grown, 1.05);
  expect_to_go_on_alike(scene, 1200);
}

TEST(Checkpoint, APressureInTimeGoesOnBitForBit) {
  for (const TimeScheme& scheme : {TimeScheme(Explicit{}), TimeScheme(SemiImplicit{})}) {
    Scene scene = drained_box(60, 2, 20);
    scene.scheme = scheme;
    scene.fluid->in_time[index(Face::z_min)] = {{{0, 0}, {0.05, 200}, {0.2, 500}}};
    scene.fluid->refresh_drift = 1e-4;
    scene.fluid->rebuild_drift = 1e-2;
    expect_to_go_on_alike(scene, 50);
  }
}

TEST(Checkpoint, ASealedBoxGoesOnBitForBit) {
  Scene scene = drained_box(60, 1.5, 1e3);
  scene.fluid->faces = {};
  scene.fluid->compressible = CompressibleFluid{1e5};
  scene.fluid->refresh_drift = 1e-4;
  scene.fluid->rebuild_drift = 1e-2;
  expect_to_go_on_alike(scene, 50);
}

TEST(Checkpoint, LeavesGrainsAsTheyAre) {
  const Scene scene = dry();
  Simulation alone(scene), saved(scene);
  advance(alone, 100);
  advance(saved, 100);
  saved.checkpoint();
  EXPECT_EQ(alone.grains().grains.packing, saved.grains().grains.packing);
  EXPECT_EQ(alone.grains().grains.velocity, saved.grains().grains.velocity);
}

TEST(Checkpoint, TakesUpAFluidOrLeavesIt) {
  Scene scene = dry();
  Simulation without(scene);
  advance(without, 50);
  const Scene wet = drained_box(60, 2, 20);
  Simulation with(wet, without.checkpoint());
  EXPECT_EQ(with.steps(), 50u);
  ASSERT_TRUE(with.fluid());
  advance(with, 10);
  Simulation again(scene, with.checkpoint());
  EXPECT_FALSE(again.fluid());
  EXPECT_EQ(again.steps(), 60u);
}

TEST(Checkpoint, OfOtherGrainsIsRefused) {
  const Scene scene = dry();
  Simulation simulation(scene);
  const Checkpoint checkpoint = simulation.checkpoint();
  const auto says = [&](const Scene& other, const char* words) {
    const std::string line = message_of<InputError>([&] { Simulation(other, checkpoint); });
    EXPECT_NE(line.find(words), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  };
  Scene other = scene;
  other.packing.spheres.pop_back();
  says(other, "grains \"60\" there, \"59\" in the scene");
  other = scene;
  other.packing.spheres[7].radius = 0.01;
  says(other, "radius of sphere 7");
  other = scene;
  other.grains.density = 3000;
  says(other, "mass of sphere");
  other = scene;
  other.grains.walls.periodic[1] = true;
  says(other, "axis y \"with walls\" there, \"periodic\" in the scene");
  other = scene;
  other.grains.cohesion = Cohesion{1, 1};
  says(other, "cohesion \"absent\" there, \"present\" in the scene");
}

TEST(Checkpoint, KeepsPressuresWhereOthersAreImposed) {
  Scene scene = drained_box(60, 2, 20);
  Simulation simulation(scene);
  advance(simulation, 20);
  const Checkpoint checkpoint = simulation.checkpoint();
  scene.fluid->faces[index(Face::z_max)] = Pressure{7};
  Simulation second(scene, checkpoint);
  const auto& system = simulation.fluid()->system();
  for (std::size_t i = 0; i < simulation.fluid()->pressure().size(); ++i)
    if (!system.known(i)) {
      EXPECT_NEAR(second.fluid()->pressure()[i], simulation.fluid()->pressure()[i], 1e-9);
    }
}

TEST(Checkpoint, OfARunThatLeftStabilityIsRefused) {
  Scene scene = drained_box(60, 2, 20);
  scene.step = 0.05;
  Simulation simulation(scene);
  advance(simulation, 19); // it looks at the twentieth
  EXPECT_THROW(simulation.checkpoint(), SolveError);
}

TEST(Checkpoint, OfOtherPoresIsRefused) {
  Scene scene = drained_box(60, 2, 20);
  Simulation simulation(scene);
  const Checkpoint checkpoint = simulation.checkpoint();
  scene.fluid->faces[index(Face::z_max)] = {};
  const std::string line = message_of<InputError>([&] { Simulation(scene, checkpoint); });
  EXPECT_NE(line.find("unknown pressures"), std::string::npos) << line;
}

} // namespace
