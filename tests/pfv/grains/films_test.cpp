#include "pfv/grains/films.hpp"
#include "pfv/problem/generate.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace pfv;

namespace {

struct Suspension {
  explicit Suspension(const Packing& packing, double reach = 0.5, const PeriodicAxes& periodic = {})
      : grains(grains_of(packing, 1000, periodic)) {
    pairs = candidate_pairs(grains, 0, {}, reach);
    at_walls = candidate_walls(grains, 0, {}, reach);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-1, 1);
    for (Velocity& of : grains.velocity)
      of = {Vec3(any(random), any(random), any(random)), 20 * Vec3(any(random), any(random), any(random))};
  }

  /// Films of the grains as they are, and what they do.
  Films films(const Lubrication& lubrication) {
    Films all(lubrication, grains.size());
    loads.assign(grains.size(), {});
    on_wall.fill(0);
    all.add_forces(grains, pairs, at_walls, loads, on_wall);
    return all;
  }
  double power() const {
    double sum = 0;
    for (std::size_t i = 0; i < grains.size(); ++i)
      sum += loads[i].force.dot(grains.velocity[i].translation) + loads[i].torque.dot(grains.velocity[i].spin);
    for (std::size_t face = 0; face < 6; ++face)
      sum += on_wall[face] * grains.wall_velocity[face];
    return sum;
  }

  Grains grains;
  CandidatePairs pairs;
  CandidateWalls at_walls;
  std::vector<Load> loads;
  std::array<double, 6> on_wall{};
};

Packing polydisperse() {
  return random_packing({.spheres = 200, .solid_fraction = 0.5, .radius_ratio = 5, .seed = 3});
}

TEST(Films, ConserveMomentumAndAngularMomentum) {
  Packing packing = polydisperse();
  packing.box = {Vec3::Constant(-9), Vec3::Constant(9)}; // walls out of reach
  Suspension suspension(packing);
  suspension.films({0.3});
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  double size = 0;
  for (std::size_t i = 0; i < suspension.grains.size(); ++i) {
    const Load& load = suspension.loads[i];
    force += load.force;
    torque += suspension.grains.sphere(i).centre.cross(load.force) + load.torque;
    size += load.force.norm();
  }
  EXPECT_LT(force.norm(), 1e-13 * size);
  EXPECT_LT(torque.norm(), 1e-13 * size);
}

TEST(Films, FeelNothingOfARigidMotion) {
  Packing packing = polydisperse();
  packing.box = {Vec3::Constant(-9), Vec3::Constant(9)};
  Suspension suspension(packing);
  const auto size_of_loads = [&] {
    suspension.films({0.3});
    double size = 0;
    for (const Load& load : suspension.loads)
      size += load.force.norm() + load.torque.norm();
    return size;
  };
  const double moving = size_of_loads();
  const Vec3 spin(1, -2, 3), translation(-1, 0.5, 2);
  for (std::size_t i = 0; i < suspension.grains.size(); ++i)
    suspension.grains.velocity[i] = {translation + spin.cross(suspension.grains.sphere(i).centre), spin};
  EXPECT_LT(size_of_loads(), 1e-11 * moving);
}

TEST(Films, ActAlikeSeenFromARotatedFrame) {
  Packing packing = polydisperse();
  packing.box = {Vec3::Constant(-9), Vec3::Constant(9)};
  Suspension here(packing);
  here.films({0.3});
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  Suspension there = here;
  for (std::size_t i = 0; i < there.grains.size(); ++i) {
    there.grains.packing.spheres[i].centre = turn * here.grains.sphere(i).centre;
    there.grains.velocity[i] = {turn * here.grains.velocity[i].translation, turn * here.grains.velocity[i].spin};
  }
  there.films({0.3});
  for (std::size_t i = 0; i < there.grains.size(); ++i) {
    EXPECT_LT((there.loads[i].force - turn * here.loads[i].force).norm(), 1e-10);
    EXPECT_LT((there.loads[i].torque - turn * here.loads[i].torque).norm(), 1e-10);
  }
}

TEST(Films, DoNotSeeWhereAPeriodicBoxIsCut) {
  const PeriodicAxes periodic{true, false, true};
  const Packing packing = random_packing({.spheres = 100, .solid_fraction = 0.5, .periodic = periodic});
  Suspension here(packing, 0.5, periodic);
  const std::size_t films = here.films({0.3}).count;
  Suspension there = here;
  for (Sphere& sphere : there.grains.packing.spheres) {
    sphere.centre += Vec3(0.4, 0, 0.7);
    sphere.centre += offset_into_box(packing.box, periodic, sphere.centre);
  }
  there.pairs = candidate_pairs(there.grains, 0, {}, 0.5);
  EXPECT_EQ(there.films({0.3}).count, films);
  EXPECT_GT(films, there.pairs.other.size()); // those at walls with them
  for (std::size_t i = 0; i < there.grains.size(); ++i) {
    EXPECT_LT((there.loads[i].force - here.loads[i].force).norm(), 1e-10);
    EXPECT_LT((there.loads[i].torque - here.loads[i].torque).norm(), 1e-10);
  }
}

TEST(Films, OnlyTakeEnergyWhateverTheyResist) {
  Suspension suspension(polydisperse());
  suspension.grains.wall_velocity = {1, -1, 0.5, 0, 0, -2};
  double sum = 0;
  for (const FilmMotion motion : all_film_motions) {
    suspension.films({0.3, 0.01, 0.5, {motion}});
    EXPECT_LT(suspension.power(), 0) << film_motion_names[static_cast<int>(motion)];
    sum += suspension.power();
  }
  const Films all = suspension.films({0.3});
  EXPECT_NEAR(suspension.power() / sum, 1, 1e-12);
  EXPECT_NEAR(all.taken(suspension.grains, 2) / (-2 * sum), 1, 1e-12);
}

TEST(Films, HaveTheStressOfTheirForcesTimesBranches) {
  // Two grains that approach along x and slide along y, far from walls: Love and Weber's sum has one film.
  Suspension pair({{Vec3::Constant(-9), Vec3::Constant(9)}, {{Vec3(-1.05, 0, 0), 1}, {Vec3(1.05, 0, 0), 1}}});
  const std::size_t left = pair.grains.sphere(0).centre.x() < 0 ? 0 : 1;
  for (std::size_t i = 0; i < 2; ++i)
    pair.grains.velocity[i] = {(i == left ? 1 : -1) * Vec3(0.5, 1, 0), Vec3::Zero()};
  const Films films = pair.films({3});
  const Vec3& on_left = pair.loads[left].force;
  Eigen::Matrix3d expected = 2.1 * Vec3::UnitX() * on_left.transpose() / std::pow(18, 3);
  const Eigen::Matrix3d stress = films.stress(pair.grains, pair.pairs, pair.at_walls);
  EXPECT_LT((stress - expected).norm(), 1e-12 * expected.norm());
  EXPECT_NEAR(stress(0, 0) * std::pow(18, 3) / (-2.1 * 1.5 * std::numbers::pi * 3 / 0.1), 1, 1e-12); // squeezed
  EXPECT_LT(stress(0, 1), 0);
}

TEST(Films, HaveTheStressThatWallsFeelWhereForcesBalance) {
  // A row of grains between two walls that close on it evenly: each grain is in balance, and the row carries what the
  // walls feel over their area.
  const double gap = 0.05, size = 3 * 2.0 + 4 * gap;
  Packing row{{Vec3(0, -9, -9), Vec3(size, 9, 9)}, {}};
  for (int n = 0; n < 3; ++n)
    row.spheres.push_back({Vec3(1 + gap + n * (2 + gap), 0, 0), 1});
  Suspension suspension(row);
  // Films at walls are four times as stiff as those between equal grains: a = 2 r there, a = r here.
  const double at_wall = 0.1, inside = 4 * at_wall;
  for (std::size_t i = 0; i < 3; ++i)
    suspension.grains.velocity[i] = {
        Vec3(-(suspension.grains.sphere(i).centre.x() - 0.5 * size) / (2 + gap) * inside, 0, 0), Vec3::Zero()};
  suspension.grains.wall_velocity = {inside + at_wall, -inside - at_wall};
  const Films films = suspension.films({3, 0.01, 0.5, {FilmMotion::normal}});
  const double carried = suspension.on_wall[1];
  EXPECT_GT(carried, 0);
  for (const Load& load : suspension.loads)
    EXPECT_LT(load.force.norm(), 1e-12 * carried);
  const Eigen::Matrix3d stress = films.stress(suspension.grains, suspension.pairs, suspension.at_walls);
  EXPECT_NEAR(stress(0, 0) / (-carried / (18 * 18)), 1, 1e-12);
}

TEST(Films, ReachAsFarAsSaidAndAreNoThinnerThanTheRoughness) {
  const auto squeeze = [](double gap) { // of two grains of radius 1 and 2, approaching at 1 m/s
    const Packing packing{{Vec3::Constant(-99), Vec3::Constant(99)}, {{Vec3::Zero(), 1}, {Vec3(3 + gap, 0, 0), 2}}};
    Suspension suspension(packing, 10);
    const std::size_t left = suspension.grains.sphere(0).radius == 1 ? 0 : 1;
    suspension.grains.velocity = {{}, {}};
    suspension.grains.velocity[left].translation.x() = 1;
    const Films films = suspension.films({1, 0.02, 0.4, {FilmMotion::normal}});
    EXPECT_EQ(films.count, gap < 0.4 ? 1u : 0u) << gap;
    EXPECT_EQ(films.at_roughness, gap < 0.02 ? 1u : 0u) << gap;
    return -suspension.loads[left].force.x();
  };
  const double a = 4.0 / 3, at_one = 1.5 * std::numbers::pi * a * a; // times 1 / gap
  EXPECT_NEAR(squeeze(0.39), at_one / 0.39, 1e-9);
  EXPECT_EQ(squeeze(0.41), 0);
  EXPECT_NEAR(squeeze(0.021), at_one / 0.021, 1e-9);
  EXPECT_NEAR(squeeze(0.01), at_one / 0.02, 1e-9);
  EXPECT_NEAR(squeeze(-0.05), at_one / 0.02, 1e-9); // in contact
}

TEST(Films, HaveTheLargestRateOfTwoGrainsAndOfAPistonThatCloses) {
  const double radius = 0.1, viscosity = 3, roughness = 0.01;
  const Lubrication squeezed{viscosity, roughness, 0.5, {FilmMotion::normal}};
  const double pi = std::numbers::pi, mass = 1000 * 4 * pi / 3 * radius * radius * radius;
  const double at_wall = 6 * pi * viscosity * radius / roughness;
  Packing packing{{Vec3::Constant(-9), Vec3::Constant(9)}, {{Vec3::Zero(), radius}}};
  const Suspension lone(packing);
  EXPECT_NEAR(Films(squeezed, 1).largest_rate(lone.grains, {}, lone.pairs, lone.at_walls), at_wall / mass, 1e-9);
  packing.box.upper.x() = 1.2 * radius;
  const Suspension near(packing);
  Walls walls;
  walls.motion[index(Face::x_max)] = LoadedWall{1, 0.5 * mass};
  EXPECT_NEAR(Films(squeezed, 1).largest_rate(near.grains, walls, near.pairs, near.at_walls), 3 * at_wall / mass, 1e-6);
}

} // namespace
