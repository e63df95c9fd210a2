#include "pfv/grains/contact_list.hpp"
#include "pfv/problem/generate.hpp"
#include "pfv/simulation/grain_cycle.hpp"

#include <gtest/gtest.h>

using namespace pfv;

namespace {

constexpr double pi = std::numbers::pi, density = 1000, radius = 0.1;
constexpr double mass = density * 4 * pi / 3 * radius * radius * radius;

GrainScene suspended(double viscosity) {
  GrainScene scene;
  scene.density = density;
  scene.law = ConstantSprings{1, 0, {0, 0}}; // soft: films alone set the pace
  scene.lubrication = Lubrication{viscosity, 1e-6, 0.5};
  return scene;
}

void run(GrainCycle& cycle, double step, int steps) {
  Clock clock;
  for (int n = 0; n < steps; ++n)
    cycle.advance(step, clock);
}

/// A grain `gap` above the floor, with its weight.
GrainCycle falling(double viscosity, double gap) {
  GrainScene scene = suspended(viscosity);
  scene.forces = {Gravity{Vec3(0, 0, -10)}};
  return {Packing{{Vec3(-9, -9, 0), Vec3::Constant(9)}, {{Vec3(0, 0, radius + gap), radius}}}, scene};
}

TEST(FilmMotion, OfAGrainThatSettlesOnAWallClosesTheGapExponentially) {
  // Without inertia 6 pi mu R^2 / h dh/dt = - m g; with it m (v - v0) = - m g t - 6 pi mu R^2 ln(h / h0) exactly.
  const double viscosity = 50, gap = 0.01, resistance = 6 * pi * viscosity * radius * radius, weight = 10 * mass;
  const double time = 2 * resistance / weight; // two e-foldings
  double before = 0;
  for (const int steps : {10000, 20000}) {
    GrainCycle cycle = falling(viscosity, gap);
    run(cycle, time / steps, steps);
    const double left = cycle.grains.sphere(0).centre.z() - radius;
    EXPECT_NEAR(left / (gap * std::exp(-2)), 1, 0.01);
    const double momentum = mass * cycle.grains.velocity[0].translation.z();
    const double error = momentum + weight * time + resistance * std::log(left / gap);
    EXPECT_LT(std::abs(error), 1e-3 * weight * time);
    if (before != 0) {
      EXPECT_NEAR(error / before, 0.5, 0.05); // the film lags by half a step
    }
    before = error;
  }
}

TEST(FilmMotion, OfTwoGrainsThatApproachStopsAtAGapSetByTheirStokesNumber) {
  // (m / 2) dv/dt = - 3/2 pi mu a^2 v / h and v = - dh/dt: the gap left is h0 exp(- (m / 2) v0 / (3/2 pi mu a^2)).
  const double viscosity = 2, gap = 0.02, velocity = 0.05, resistance = 1.5 * pi * viscosity * radius * radius;
  const double stokes = 0.5 * mass * velocity / resistance;
  ASSERT_GT(stokes, 1);
  const double x = radius + 0.5 * gap;
  GrainCycle cycle({{Vec3::Constant(-9), Vec3::Constant(9)}, {{Vec3(-x, 0, 0), radius}, {Vec3(x, 0, 0), radius}}},
                   suspended(viscosity));
  for (std::size_t i = 0; i < 2; ++i)
    cycle.grains.velocity[i].translation.x() = std::copysign(0.5 * velocity, -cycle.grains.sphere(i).centre.x());
  run(cycle, 1e-4, 30000);
  const double left = (cycle.grains.sphere(1).centre - cycle.grains.sphere(0).centre).norm() - 2 * radius;
  EXPECT_LT(cycle.grains.velocity[0].translation.norm(), 1e-6 * velocity);
  EXPECT_NEAR(left / (gap * std::exp(-stokes)), 1, 1e-2);
  EXPECT_NEAR(cycle.energy.lubrication / (0.25 * mass * velocity * velocity), 1, 1e-9);
}

GrainCycle shaken(double viscosity) {
  GrainScene scene;
  scene.law = LinearSprings{1e6, 0.5, {0.4, 0.05}};
  scene.damping = {0.05};
  scene.forces = {Gravity{Vec3(0, 0, -9.81)}};
  scene.walls.motion[index(Face::z_max)] = LoadedWall{2000, 500};
  scene.walls.motion[index(Face::x_min)] = MovingWall{0.01};
  scene.lubrication = Lubrication{viscosity};
  GrainCycle cycle(random_packing({.spheres = 100, .solid_fraction = 0.5, .radius_ratio = 3}), scene);
  for (std::size_t i = 0; i < cycle.grains.size(); ++i)
    cycle.grains.velocity[i].spin = Vec3(std::sin(1.0 + i), std::sin(2.0 + 3.0 * i), std::sin(3.0 + 7.0 * i));
  return cycle;
}

TEST(FilmMotion, LosesWhatLoadsAndWeightPutInAndNobodyElseTakes) {
  GrainCycle cycle = shaken(1);
  const auto stored = [&](double elastic) { return kinetic_energy(cycle.grains, cycle.scene.walls) + elastic; };
  const double start = stored(elastic_energy(cycle.grains, cycle.contacts));
  const double step = std::min(0.02 * cycle.contact_limit(), 0.2 * *cycle.lubrication_limit());
  run(cycle, step, 8000);
  const double elastic = elastic_energy(cycle.grains, cycle.contacts);
  run(cycle, step, 1);
  const double now = stored(0.5 * (elastic + elastic_energy(cycle.grains, cycle.contacts)));
  const double put_in = start + cycle.energy.loads + cycle.energy.gravity;
  EXPECT_GT(cycle.energy.lubrication, 0.1 * put_in);
  EXPECT_GT(cycle.films->at_roughness, 0u);
  EXPECT_NEAR((now + cycle.energy.lost()) / put_in, 1, 1e-3);
}

TEST(FilmMotion, IsStableJustBelowItsLimitAndNotJustAbove) {
  for (const auto& resists : {std::vector{FilmMotion::normal}, std::vector{FilmMotion::shear, FilmMotion::roll},
                              std::vector(all_film_motions.begin(), all_film_motions.end())})
    for (const double share : {0.98, 1.02}) {
      GrainScene scene = suspended(1e3);
      scene.lubrication->roughness = 0.01;
      scene.lubrication->resists = resists;
      Packing lattice = lattice_packing(Lattice::simple_cubic, touching_solid_fraction(Lattice::simple_cubic), 3);
      for (Sphere& sphere : lattice.spheres)
        sphere.radius *= 1.001; // all films at the roughness
      GrainCycle cycle(lattice, scene);
      ASSERT_LT(*cycle.lubrication_limit(), 1e-3 * cycle.contact_limit());
      for (std::size_t i = 0; i < cycle.grains.size(); ++i) {
        const auto x = static_cast<double>(i);
        cycle.grains.velocity[i] = {1e-5 * Vec3(std::sin(1 + x), std::sin(2 + 3 * x), std::sin(3 + 7 * x)),
                                    1e-4 * Vec3(std::sin(4 + 5 * x), std::sin(5 + 2 * x), std::sin(6 + 9 * x))};
      }
      const double start = kinetic_energy(cycle.grains, scene.walls);
      run(cycle, share * *cycle.lubrication_limit(), 500);
      const double growth = kinetic_energy(cycle.grains, scene.walls) / start;
      if (share < 1)
        EXPECT_LT(growth, 1);
      else
        EXPECT_GT(growth, 1e6);
    }
}

TEST(FilmMotion, CountsInTheStressBesideContacts) {
  GrainCycle cycle = shaken(1);
  run(cycle, 0.1 * *cycle.lubrication_limit(), 100);
  const Contacts::Memory& near = cycle.contacts.memory();
  const Eigen::Matrix3d of_films = cycle.films->stress(cycle.grains, near.pairs, near.at_walls);
  EXPECT_GT(of_films.norm(), 0);
  EXPECT_EQ(cycle.stress(), contact_stress(cycle.grains, cycle.contacts) + of_films);
}

} // namespace
