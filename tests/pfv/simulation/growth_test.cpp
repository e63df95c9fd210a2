#include "pfv/problem/error.hpp"
#include "pfv/simulation/read_scene.hpp"
#include "pfv/simulation/relax.hpp"
#include "scenes.hpp"

#include "support/message_of.hpp"
#include "support/temporary_file.hpp"

#include <gtest/gtest.h>

#include <sstream>

using namespace pfv;
using namespace pfv::testing;

namespace {

constexpr double stress = 1000, unbalanced = 1e-3;

Scene growing(const PeriodicAxes& periodic = {}) {
  Scene scene;
  scene.packing =
      random_packing({.spheres = 200, .solid_fraction = 0.45, .radius_ratio = 2, .seed = 2, .periodic = periodic});
  scene.grains.law = LinearSprings{1e6, 0.5, {0.3, 0}};
  scene.grains.damping.share = 0.3;
  scene.grains.walls.periodic = periodic;
  scene.grains.growth = Growth{0.02, stress};
  return scene;
}

GrainCycle grown(const Scene& scene) {
  GrainCycle cycle(scene.packing, scene.grains);
  Clock clock;
  relax(cycle, {unbalanced}, clock);
  return cycle;
}

TEST(Growth, OfOneGrainInABoxStopsAtTheStress) {
  // 2 E r (r - 1/2) on each wall of a unit cube.
  Scene scene = growing();
  scene.packing.spheres = {{{0.5, 0.5, 0.5}, 0.45}};
  scene.grains.growth->rate = 0.1;
  const double radius = grown(scene).grains.sphere(0).radius;
  EXPECT_NEAR(2e6 * radius * (radius - 0.5) / stress, 1, 2e-3);
}

TEST(Growth, BringsAPackingToTheStressAndToRest) {
  for (const PeriodicAxes& periodic : {PeriodicAxes{}, PeriodicAxes{true, true, true}}) {
    const Scene scene = growing(periodic);
    const GrainCycle cycle = grown(scene);
    EXPECT_LE(cycle.unbalanced_force(), unbalanced);
    EXPECT_NEAR(mean_stress(cycle.stress()) / stress, 1, 1e-3);
    double on_walls = 0;
    for (const Face face : all_faces)
      on_walls += std::abs(cycle.on_wall[index(face)]) / area_of(scene.packing.box, face) / 6;
    EXPECT_NEAR(on_walls, periodic[0] ? 0 : stress, 0.02 * stress);
    EXPECT_EQ(cycle.grains.packing.box, scene.packing.box);
    EXPECT_GT(cycle.grains.grown, 1.05);
    for (std::size_t i = 0; i < cycle.grains.size(); ++i) {
      const Sphere& sphere = cycle.grains.sphere(i);
      EXPECT_EQ(sphere.radius, cycle.grains.grown * scene.packing.spheres[cycle.grains.number[i]].radius);
      EXPECT_EQ(cycle.grains.mass[i], scene.grains.density * volume(sphere));
    }
  }
}

TEST(Growth, PutsInWhatIsStoredOrLost) {
  for (const ContactLaw& law :
       {ContactLaw(LinearSprings{1e6, 0.5, {0.3, 0.1}}), ContactLaw(HertzMindlin{1e8, 0.3, {0, 0}})}) {
    Scene scene = growing();
    scene.grains.law = law;
    scene.grains.growth->rate = 0.2;
    scene.step = 0.1 * limits_of(GrainCycle(scene.packing, scene.grains)).chosen();
    Simulation simulation(scene);
    EXPECT_NEAR(energy_balance(simulation, static_cast<int>(1 / *scene.step)), 1, 2e-3);
    EXPECT_GT(simulation.grains().energy.growth, 0);
    EXPECT_EQ(simulation.grains().energy.loads, 0);
  }
}

TEST(Growth, LeavesGrainsThatArePressedHarderAsTheyBegan) {
  Scene scene = growing();
  scene.packing.spheres = {{{0.5, 0.5, 0.5}, 0.51}};
  scene.grains.growth->stress = 10;
  Simulation simulation(scene);
  for (int n = 0; n < 100; ++n)
    simulation.advance();
  EXPECT_NEAR(simulation.grains().grains.grown, 1, 1e-12);
}

TEST(Growth, IsAStartForOtherScenes) {
  const Scene scene = growing();
  Simulation simulation(scene, grown(scene));
  const Checkpoint saved = simulation.checkpoint();
  Scene pressed = scene;
  pressed.grains.growth.reset();
  pressed.grains.walls.motion[index(Face::z_max)] = LoadedWall{stress, 1e3};
  Simulation with_springs(pressed, saved);
  for (int n = 0; n < 500; ++n)
    with_springs.advance();
  EXPECT_EQ(with_springs.grains().grains.grown, saved.grains.grown);
  EXPECT_NEAR(height(with_springs), 1, 2e-3);
  EXPECT_NEAR(mean_stress(with_springs.grains().stress()) / stress, 1, 0.1);

  std::ostringstream text;
  write_packing(packing_of(simulation.grains().grains), text);
  const TemporaryFile packing("grown.txt", text.str());
  const TemporaryFile file("wet.toml", "[packing]\nfile = \"" + packing.path().string() +
                                           "\"\n[contact]\nyoung = 1e6\n[flow]\naxis = \"z\"\n");
  Simulation wet(read_scene(file.path()).scene);
  wet.advance();
  EXPECT_NEAR(mean_stress(wet.grains().stress()) / stress, 1, 0.1); // without the springs' shear
}

TEST(Growth, EndsWhereAPeriodicBoxGetsTooNarrow) {
  Scene scene = growing({true, true, true});
  scene.packing = random_packing(
      {.spheres = 20, .solid_fraction = 0.3, .radius_ratio = 1, .seed = 2, .periodic = {true, true, true}});
  scene.grains.growth = Growth{1, 1e12};
  Simulation simulation(scene);
  const std::string line = message_of<InputError>([&] {
    for (int n = 0; n < 3000; ++n)
      simulation.advance();
  });
  EXPECT_NE(line.find("along its periodic axis"), std::string::npos) << line;
}

} // namespace
