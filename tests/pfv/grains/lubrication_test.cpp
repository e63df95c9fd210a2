#include "pfv/grains/film_load.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace pfv;

namespace {

constexpr double pi = std::numbers::pi, viscosity = 0.7, wall = 1e9; // a radius of 1e9 is a wall

struct Spheres {
  double first, second; // m
  double harmonic() const { return 2 * first * second / (first + second); }
  double skew() const { return (first - second) / (first + second); }
  double beta() const { return second / first; }
};

struct Motion {
  Vec3 translation, spin;
};

struct TwoLoads {
  Vec3 force, torque, torque_of_second; // about the centres
};

/// The film between two spheres along x, the first fixed at the origin but for its motion.
TwoLoads loads(const Spheres& of, double gap, const Motion& first, const Motion& second) {
  const double arm_1 = of.first + 0.5 * gap, arm_2 = of.second + 0.5 * gap;
  FilmBetween film;
  film.normal = Vec3::UnitX();
  film.sliding = second.translation - first.translation - (arm_1 * first.spin + arm_2 * second.spin).cross(film.normal);
  film.spin = first.spin - second.spin;
  film.radius = of.harmonic();
  film.skew = of.skew();
  const FilmLoad load = film_load(film_resistance(viscosity, film.radius, gap), film);
  const Vec3 turn = film.normal.cross(load.force);
  return {load.force, arm_1 * turn + load.couple, arm_2 * turn - load.couple};
}

const Motion rest{Vec3::Zero(), Vec3::Zero()};

/// What multiplies ln(1 / h) in the limit of a closed gap, from two gaps.
Vec3 per_logarithm(Vec3 TwoLoads::*of, const Spheres& spheres, const Motion& first, const Motion& second) {
  const double wide = 1e-9 * spheres.first, narrow = 1e-12 * spheres.first;
  return (loads(spheres, narrow, first, second).*of - loads(spheres, wide, first, second).*of) / std::log(1e3);
}

const std::vector<Spheres> ratios{{1, 1}, {1, 2}, {3, 1}, {0.2, 1}, {1, 20}};

TEST(Lubrication, HasTheSqueezeForceOfJeffreyAndOnishi) {
  for (const auto& [first, second] : ratios) {
    const double gap = 1e-6 * first, beta = second / first, xi = 2 * gap / (first + second);
    const double force = loads({first, second}, gap, {Vec3::UnitX(), Vec3::Zero()}, rest).force.x();
    EXPECT_NEAR(force / (-6 * pi * viscosity * first * 2 * beta * beta / std::pow(1 + beta, 3) / xi), 1, 1e-12);
  }
  const double at_plane = loads({1, wall}, 1e-3, {Vec3::UnitX(), Vec3::Zero()}, rest).force.x();
  EXPECT_NEAR(at_plane / (-6 * pi * viscosity / 1e-3), 1, 1e-8); // Brenner (1961), near the plane
}

TEST(Lubrication, HasTheLogarithmsOfJeffreyAndOnishiAtAnyRatioOfRadii) {
  const Motion slides{Vec3::UnitY(), Vec3::Zero()}, turns{Vec3::Zero(), Vec3::UnitZ()};
  for (const Spheres& of : ratios) {
    const double a = of.first, b = of.beta(), mean = 0.5 * (of.first + of.second);
    const double y_a = 4.0 / 15 * b * (2 + b + 2 * b * b) / std::pow(1 + b, 3),
                 y_b = b * (4 + b) / std::pow(1 + b, 2) / 5;
    const double y_c = 2.0 / 5 * b / (1 + b), y_c_12 = 4.0 / 5 * b * b / std::pow(1 + b, 4);
    EXPECT_NEAR(per_logarithm(&TwoLoads::force, of, slides, rest).y() / (-6 * pi * viscosity * a * y_a), 1, 1e-6);
    // A sphere that moves up beside one at rest on its right is turned backwards, and pushed down when it turns
    // forwards.
    EXPECT_NEAR(per_logarithm(&TwoLoads::torque, of, slides, rest).z() / (-4 * pi * viscosity * a * a * y_b), 1, 1e-6);
    EXPECT_NEAR(per_logarithm(&TwoLoads::force, of, turns, rest).y() / (-4 * pi * viscosity * a * a * y_b), 1, 1e-6);
    EXPECT_NEAR(per_logarithm(&TwoLoads::torque, of, turns, rest).z() / (-8 * pi * viscosity * a * a * a * y_c), 1,
                1e-6);
    EXPECT_NEAR(per_logarithm(&TwoLoads::torque_of_second, of, turns, rest).z() /
                    (-8 * pi * viscosity * std::pow(mean, 3) * y_c_12),
                1, 1e-6);
  }
}

TEST(Lubrication, HasTheLogarithmsOfASphereAtAPlane) {
  // Goldman, Cox & Brenner (1967).
  const Motion slides{Vec3::UnitY(), Vec3::Zero()}, turns{Vec3::Zero(), Vec3::UnitZ()};
  EXPECT_NEAR(per_logarithm(&TwoLoads::force, {1, wall}, slides, rest).y(), -6 * pi * viscosity * 8 / 15, 1e-6);
  EXPECT_NEAR(per_logarithm(&TwoLoads::torque, {1, wall}, slides, rest).z(), -8 * pi * viscosity / 10, 1e-6);
  EXPECT_NEAR(per_logarithm(&TwoLoads::torque, {1, wall}, turns, rest).z(), -8 * pi * viscosity * 2 / 5, 1e-6);
}

TEST(Lubrication, OfRollingAndTwistHasTheNextTermOfEqualSpheres) {
  const double xi = 0.01, zeta_3 = 1.2020569031595942;
  const Motion forwards{Vec3::Zero(), Vec3(1, 0, 1)}, backwards{Vec3::Zero(), Vec3(-1, 0, -1)};
  const Vec3 torque = loads({1, 1}, xi, forwards, backwards).torque;
  const double logarithm = std::log(1 / xi);
  const double y_11 = logarithm * (1.0 / 5 + 47.0 / 250 * xi), y_12 = logarithm * (1.0 / 20 + 31.0 / 500 * xi);
  const double x_12 = -zeta_3 / 8 + xi * logarithm / 8;
  EXPECT_NEAR(torque.z(), -8 * pi * viscosity * (y_11 - y_12), 1e-12);
  EXPECT_NEAR(torque.x(), -8 * pi * viscosity * 2 * -x_12,
              1e-12); // what the other's spin does, at twice the difference
}

TEST(Lubrication, OfTwistHasTheContactValueAtAnyRatioAndAPlane) {
  const double zeta_3 = 1.2020569031595942;
  const Motion twists{Vec3::Zero(), Vec3::UnitX()};
  for (const Spheres& of : ratios) {
    const double b = of.beta(), mean = 0.5 * (of.first + of.second),
                 x_12 = 8 * std::pow(b, 3) / std::pow(1 + b, 6) * zeta_3;
    EXPECT_NEAR(loads(of, 1e-12, twists, rest).torque_of_second.x() / (8 * pi * viscosity * std::pow(mean, 3) * x_12),
                1, 1e-9);
  }
  EXPECT_NEAR(loads({1, wall}, 1e-12, twists, rest).torque.x(), -8 * pi * viscosity * zeta_3, 1e-6); // Jeffery (1915)
}

TEST(Lubrication, OfShearFadesWithDistance) {
  EXPECT_NEAR(film_resistance(viscosity, 1, 1e-3).shear, 0.5 * pi * viscosity * (-2 + 2.001 * std::log(2.001 / 1e-3)),
              1e-12);
  EXPECT_GT(film_resistance(viscosity, 1, 100).shear, 0);
  EXPECT_LT(film_resistance(viscosity, 1, 100).shear, 0.04 * viscosity);
}

TEST(Lubrication, GrowsAsTheGapCloses) {
  FilmResistance before{};
  for (double gap = 1; gap > 1e-6; gap *= 0.9) {
    const FilmResistance now = film_resistance(viscosity, 1, gap);
    EXPECT_GT(now.normal, before.normal);
    EXPECT_GT(now.shear, before.shear);
    EXPECT_GE(now.roll, before.roll);
    EXPECT_GT(now.twist, 0);
    before = now;
  }
}

TEST(Lubrication, VanishesWhenBothSpheresTurnAsOneBody) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto vector = [&] { return Vec3(any(random), any(random), any(random)); };
  for (const Spheres& of : ratios) {
    const double gap = 0.1 * of.first;
    const Vec3 spin = vector(), translation = vector();
    const Vec3 apart = (of.first + of.second + gap) * Vec3::UnitX();
    const auto [force, torque, other] = loads(of, gap, {translation, spin}, {translation + spin.cross(apart), spin});
    EXPECT_LT(force.norm() + torque.norm() + other.norm(), 1e-12);
  }
}

TEST(Lubrication, OnlyTakesEnergyAndBalancesItsTorques) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-1, 1), exponent(-6, 0);
  const auto vector = [&] { return Vec3(any(random), any(random), any(random)); };
  for (int n = 0; n < 1000; ++n)
    for (const Spheres& of : ratios) {
      const double gap = std::pow(10, exponent(random)) * std::min(of.first, of.second);
      const Motion first{vector(), vector()}, second{vector(), vector()};
      const auto [force, torque, other] = loads(of, gap, first, second);
      const double power =
          force.dot(first.translation - second.translation) + torque.dot(first.spin) + other.dot(second.spin);
      EXPECT_LT(power, 0);
      const Vec3 apart = (of.first + of.second + gap) * Vec3::UnitX();
      EXPECT_LT((torque + other - apart.cross(force)).norm(), 1e-12 * (torque.norm() + other.norm()));
    }
}

} // namespace
