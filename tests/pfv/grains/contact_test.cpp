#include "pfv/simulation/grain_cycle.hpp"

#include "pfv/grains/contact_list.hpp"

#include <gtest/gtest.h>

#include <numbers>

using namespace pfv;

namespace {

constexpr double density = 1000, radius = 0.1, stiffness = 1e4, touch = 2 * radius;

GrainScene springs(double friction = 0, double damping = 0) {
  GrainScene scene;
  scene.density = density;
  scene.law = ConstantSprings{stiffness, 0.5 * stiffness, {friction, damping}};
  return scene;
}

/// Two grains along x in a wide box, `gap` apart.
Packing two_grains(double gap) {
  const double x = radius + 0.5 * gap;
  return {{Vec3::Constant(-10), Vec3::Constant(10)}, {{Vec3(-x, 0, 0), radius}, {Vec3(x, 0, 0), radius}}};
}

void run(GrainCycle& cycle, double step, int steps) {
  Clock clock;
  for (int n = 0; n < steps; ++n) {
    cycle.advance(step, clock);
  }
}

double gap(const GrainCycle& cycle) {
  return (cycle.grains.sphere(1).centre - cycle.grains.sphere(0).centre).norm() - touch;
}

/// Sets the relative velocity of the two grains, as it is half a step before the start.
void approach(GrainCycle& cycle, double velocity) {
  const double sign = cycle.grains.sphere(0).centre.x() < 0 ? 1 : -1;
  cycle.grains.velocity[0].translation.x() = 0.5 * sign * velocity;
  cycle.grains.velocity[1].translation.x() = -0.5 * sign * velocity;
}

/// Of a collision without losses the overlap is v sin(w t) / w, w^2 = 2 k / m, from first touch on.
double worst_error_of_collision(int steps_per_period) {
  const double mass = density * 4 * std::numbers::pi / 3 * radius * radius * radius;
  const double frequency = std::sqrt(2 * stiffness / mass), velocity = 0.1;
  const double step = 2 * std::numbers::pi / frequency / steps_per_period;
  GrainCycle cycle(two_grains(0), springs());
  approach(cycle, velocity);
  drift(cycle.grains, 0.5 * step); // velocities are those at its middle
  Clock clock;
  double worst = 0;
  for (double time = 0.5 * step; time < 0.9 * std::numbers::pi / frequency; time += step) {
    const double exact = velocity / frequency * std::sin(frequency * time);
    worst = std::max(worst, std::abs(-gap(cycle) - exact) * frequency / velocity);
    cycle.advance(step, clock);
  }
  return worst;
}

TEST(Contact, CollidesAsTheAnalyticSolutionWithErrorOfSecondOrder) {
  const double coarse = worst_error_of_collision(100), fine = worst_error_of_collision(200);
  EXPECT_LT(coarse, 2e-3);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.2);
}

TEST(Contact, ReboundsWithTheRestitutionOfItsDamping) {
  const double share = 0.1;
  const double mass = density * 4 * std::numbers::pi / 3 * radius * radius * radius;
  const double frequency = std::sqrt(2 * stiffness / mass);
  const double step = 2e-4 / frequency;
  GrainCycle cycle(two_grains(0), springs(0, share));
  approach(cycle, 0.1);
  run(cycle, step, static_cast<int>(3.5 / frequency / step));
  const double parted = (cycle.grains.velocity[1].translation - cycle.grains.velocity[0].translation).norm();
  // Released when the force, not the overlap, is zero: Schwager & Poeschel, Granular Matter 9 (2007) 465.
  const double damped = std::sqrt(1 - share * share);
  EXPECT_NEAR(parted / 0.1,
              std::exp(-share / damped * (std::numbers::pi - std::atan2(2 * share * damped, 1 - 2 * share * share))),
              2e-3);
}

TEST(Contact, ConservesMomentumAndAngularMomentum) {
  GrainScene scene = springs(0.3);
  GrainCycle cycle(two_grains(0.01), scene);
  approach(cycle, 0.5);
  cycle.grains.velocity[0].translation.y() = 0.2;
  cycle.grains.velocity[0].spin = Vec3(1, 2, 3);
  const auto momenta = [&] {
    Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
    for (std::size_t i = 0; i < 2; ++i) {
      const auto& [translation, spin] = cycle.grains.velocity[i];
      linear += cycle.grains.mass[i] * translation;
      angular +=
          cycle.grains.mass[i] * cycle.grains.sphere(i).centre.cross(translation) + cycle.grains.inertia(i) * spin;
    }
    return std::pair(linear, angular);
  };
  const auto [linear, angular] = momenta();
  run(cycle, 1e-4, 2000);
  ASSERT_GT(gap(cycle), 0) << "they should have met and parted";
  EXPECT_GT(cycle.energy.friction, 0);
  EXPECT_LT((momenta().first - linear).norm(), 1e-14);
  EXPECT_LT((momenta().second - angular).norm(), 1e-14);
}

/// A grain pressed on the floor by its weight and pushed along it.
GrainCycle grain_on_floor(double wall_friction, double push) {
  GrainScene scene = springs();
  scene.walls.friction = wall_friction;
  scene.forces = {Gravity{Vec3(push, 0, -10)}};
  const double mass = density * 4 * std::numbers::pi / 3 * radius * radius * radius;
  const double sunk = 10 * mass / stiffness;
  return {Packing{{Vec3(-10, -10, 0), Vec3::Constant(10)}, {{Vec3(0, 0, radius - sunk), radius}}}, scene};
}

TEST(Contact, SlidesWhenPushedBeyondCoulombsLimit) {
  // A ball pushed at its centre rolls without sliding while its push is below 3.5 mu g, and then has 5/7 of it, or a
  // little less, as it has sunk into the floor.
  const double push = 10, step = 1e-4;
  GrainCycle rolling = grain_on_floor(0.5, push);
  run(rolling, step, 10000);
  const double arm = rolling.grains.sphere(0).centre.z(), inertia = 0.4 * radius * radius / (arm * arm);
  EXPECT_NEAR(rolling.grains.velocity[0].translation.x(), push / (1 + inertia), 2e-3 * push);
  EXPECT_NEAR(rolling.energy.friction, 0, 1e-3 * rolling.energy.gravity);

  const double mu = 0.1;
  GrainCycle sliding = grain_on_floor(mu, push);
  run(sliding, step, 10000);
  EXPECT_NEAR(sliding.grains.velocity[0].translation.x(), push - mu * 10, 1e-3 * push);
  EXPECT_NEAR(sliding.grains.velocity[0].spin.y(), 2.5 * mu * 10 * arm / (radius * radius), 0.3);
}

TEST(Contact, BondBreaksAtItsTensileStrength) {
  const double strength = 2000, section = std::numbers::pi * radius * radius;
  GrainScene scene = springs();
  scene.cohesion = Cohesion{strength, strength};
  const double most = strength * section / stiffness; // m, of extension
  for (const double share : {0.999, 1.001}) {
    GrainCycle cycle(two_grains(0), scene);
    for (Sphere& sphere : cycle.grains.packing.spheres)
      sphere.centre.x() += std::copysign(0.5 * share * most, sphere.centre.x());
    Clock clock;
    cycle.load(1e-9, clock);
    EXPECT_EQ(cycle.broken_bonds, share > 1 ? 1u : 0u);
    EXPECT_NEAR(cycle.loads[0].force.norm(), share > 1 ? 0 : share * strength * section, 1e-9);
  }
}

TEST(Contact, BondBreaksAtItsShearStrengthAndRubsFromThenOn) {
  const double strength = 500, section = std::numbers::pi * radius * radius;
  GrainScene scene = springs(0.3);
  scene.cohesion = Cohesion{1e9, strength};
  const double overlap = 1e-4, coulomb = 0.3 * stiffness * overlap;
  for (const double share : {0.99, 1.01}) {
    GrainCycle cycle(two_grains(-overlap), scene);
    const double slid = share * (strength * section + coulomb) / (0.5 * stiffness);
    const std::size_t right = cycle.grains.sphere(0).centre.x() > 0 ? 0 : 1;
    cycle.grains.velocity[right].translation.y() = slid; // in one step of a second, without moving
    Clock clock;
    cycle.load(1, clock);
    EXPECT_EQ(cycle.broken_bonds, share > 1 ? 1u : 0u);
    EXPECT_NEAR(std::abs(cycle.loads[0].force.y()), share > 1 ? coulomb : share * (strength * section + coulomb), 1e-9);
  }
}

TEST(Contact, HertzMindlinTakesTheTextbookForce) {
  GrainScene scene = springs();
  scene.law = HertzMindlin{1e9, 0.25, {0, 0}};
  const double overlap = 1e-4;
  GrainCycle cycle(two_grains(-overlap), scene);
  Clock clock;
  cycle.load(1e-9, clock);
  const double effective = 1e9 / (2 * (1 - 0.25 * 0.25));
  EXPECT_NEAR(cycle.loads[0].force.norm(), 4.0 / 3 * effective * std::sqrt(radius / 2) * std::pow(overlap, 1.5), 1e-9);
}

} // namespace
