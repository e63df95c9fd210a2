#include "pfv/simulation/grain_cycle.hpp"

#include "pfv/grains/contact_list.hpp"
#include "pfv/problem/generate.hpp"

#include <gtest/gtest.h>

using namespace pfv;

namespace {

void run(GrainCycle& cycle, double step, int steps) {
  Clock clock;
  for (int n = 0; n < steps; ++n) {
    cycle.advance(step, clock);
  }
}

void shake(GrainCycle& cycle, double velocity) {
  for (std::size_t i = 0; i < cycle.grains.size(); ++i)
    cycle.grains.velocity[i].translation =
        velocity * Vec3(std::sin(1.0 + i), std::sin(2.0 + 3.0 * i), std::sin(3.0 + 7.0 * i));
}

/// Kinetic and elastic, both at the middle between two positions but for an error of second order.
double mechanical(GrainCycle& cycle, double step) {
  const double before = elastic_energy(cycle.grains, cycle.contacts);
  run(cycle, step, 1);
  return kinetic_energy(cycle.grains, cycle.scene.walls) +
         0.5 * (before + elastic_energy(cycle.grains, cycle.contacts));
}

TEST(Energy, IsConservedWithoutLossesOver100000Steps) {
  GrainScene scene;
  scene.law = ConstantSprings{1e4, 0, {0, 0}};
  GrainCycle cycle(random_packing({.spheres = 12, .solid_fraction = 0.3}), scene);
  shake(cycle, 0.02);
  const double step = 1e-3 * cycle.contact_limit();
  const double start = mechanical(cycle, step);
  double worst = 0;
  for (int n = 0; n < 100; ++n) {
    run(cycle, step, 999);
    worst = std::max(worst, std::abs(mechanical(cycle, step) / start - 1));
  }
  EXPECT_LT(worst, 1e-6);
}

/// Whether what loads and weight put in is found again, but for a share.
void expect_balance(const ContactLaw& law, double share) {
  GrainScene scene;
  scene.law = law;
  scene.damping = {0.1};
  scene.forces = {Gravity{Vec3(0, 0, -9.81)}};
  scene.walls.motion[index(Face::z_max)] = LoadedWall{2000, 500};
  scene.walls.motion[index(Face::x_min)] = MovingWall{0.01};
  scene.walls.friction = 0.2;
  GrainCycle cycle(random_packing({.spheres = 200, .solid_fraction = 0.5, .radius_ratio = 3}), scene);
  const double step = 0.02 * cycle.contact_limit();
  run(cycle, step, 20000);
  const double stored = mechanical(cycle, step);
  const double put_in = cycle.energy.loads + cycle.energy.gravity;
  EXPECT_GT(cycle.energy.friction, 0.01 * put_in);
  EXPECT_GT(cycle.energy.local_damping, 0.01 * put_in);
  EXPECT_NEAR((stored + cycle.energy.lost()) / put_in, 1, share);
}

TEST(Energy, OfLoadsAndWeightIsKineticElasticOrLost) {
  expect_balance(LinearSprings{1e6, 0.5, {0.4, 0.05}}, 1e-3);
}

TEST(Energy, OfHertzAndMindlinIsFoundAgainToAHundredth) {
  expect_balance(HertzMindlin{1e7, 0.3, {0.4, 0.05}}, 1e-2); // see HertzMindlin
}

TEST(Energy, StaysBoundedBelowTheContactLimitAndNotAbove) {
  for (const double share : {0.97, 1.05}) {
    GrainScene scene;
    scene.law = ConstantSprings{1e4, 5e3, {1e9, 0}}; // nothing slips
    Packing lattice = lattice_packing(Lattice::simple_cubic, touching_solid_fraction(Lattice::simple_cubic), 3);
    for (Sphere& sphere : lattice.spheres)
      sphere.radius *= 1.001;
    GrainCycle cycle(lattice, scene);
    shake(cycle, 1e-9); // and what the walls push it to: below 0.1 J
    const double step = share * cycle.contact_limit();
    run(cycle, step, 3000);
    const double kinetic = kinetic_energy(cycle.grains, scene.walls);
    if (share < 1)
      EXPECT_LT(kinetic, 1);
    else
      EXPECT_FALSE(kinetic < 100);
  }
}

} // namespace
