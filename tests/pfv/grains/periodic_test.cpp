#include "pfv/grains/contact_list.hpp"
#include "pfv/grains/motion.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"

#include <gtest/gtest.h>

#include <set>

using namespace pfv;

namespace {

constexpr PeriodicAxes sideways{true, true, false}, all_around{true, true, true};

Grains grains_in(const PeriodicAxes& periodic, int spheres, double ratio) {
  return grains_of(
      random_packing(
          {.spheres = spheres, .solid_fraction = 0.4, .radius_ratio = ratio, .seed = 5, .periodic = periodic}),
      1000, periodic);
}

TEST(PeriodicGrains, MeetTheNearestImagesOfAllThatAreNear) {
  for (const PeriodicAxes& periodic : {sideways, all_around, PeriodicAxes{false, false, true}}) {
    Grains grains = grains_in(periodic, 300, 4);
    for (std::size_t i = 0; i < grains.size(); i += 3) // some have left the box, by far
      for (int axis = 0; axis < 3; ++axis)
        grains.packing.spheres[i].centre[axis] += periodic[axis] ? static_cast<double>(i % 5) - 2 : 0;
    const double margin = 0.02;
    const CandidatePairs pairs = candidate_pairs(grains, margin);
    std::set<std::pair<int, int>> found, near;
    for (int i = 0; i < static_cast<int>(grains.size()); ++i) {
      for (int e = pairs.start[i]; e < pairs.start[i + 1]; ++e) {
        EXPECT_TRUE(found.emplace(i, pairs.other[e]).second);
        EXPECT_LT(apart(pairs, e, grains.sphere(i), grains.sphere(pairs.other[e])).norm(),
                  grains.sphere(i).radius + grains.sphere(pairs.other[e]).radius + margin);
      }
      for (int j = i + 1; j < static_cast<int>(grains.size()); ++j) {
        Vec3 between = grains.sphere(j).centre - grains.sphere(i).centre;
        for (int axis = 0; axis < 3; ++axis)
          between[axis] -= periodic[axis] ? std::round(between[axis]) : 0;
        if (between.norm() < grains.sphere(i).radius + grains.sphere(j).radius + margin)
          near.emplace(i, j);
      }
    }
    EXPECT_EQ(found, near);
  }
}

TEST(PeriodicGrains, CollideAcrossTheBoxAsInside) {
  const auto speed_after = [](double x, const PeriodicAxes& periodic) {
    Packing packing{{Vec3::Zero(), Vec3::Ones()}, {{{x - 0.11, 0.5, 0.5}, 0.1}, {{x + 0.11, 0.5, 0.5}, 0.1}}};
    for (Sphere& sphere : packing.spheres)
      sphere.centre.x() -= std::floor(sphere.centre.x());
    Grains grains = grains_of(packing, 1000, periodic);
    for (std::size_t i = 0; i < 2; ++i)
      grains.velocity[i].translation.x() = grains.number[i] == 0 ? 1 : -1;
    Contacts contacts(LinearSprings{1e5, 0.5, {0.5, 0}}, 0, {}, grains);
    for (int n = 0; n < 2000; ++n) {
      std::vector<Load> loads(2);
      std::array<double, 6> on_wall{};
      contacts.add_forces(grains, 5e-5, loads, on_wall);
      kick(grains, Walls{}, loads, on_wall, {}, 5e-5);
      drift(grains, 5e-5);
    }
    return grains.velocity[grains.number[0] == 0 ? 0 : 1].translation.x();
  };
  const double inside = speed_after(0.5, {});
  EXPECT_LT(inside, -0.9);
  EXPECT_NEAR(speed_after(0, {true, false, false}), inside, 1e-9);
}

TEST(PeriodicGrains, GoOnBeyondTheBoxAndAreWrittenInsideIt) {
  Grains grains = grains_in(all_around, 40, 1);
  for (Velocity& velocity : grains.velocity)
    velocity.translation = Vec3(3.2, -2.1, 0.4);
  const Packing before = packing_of(grains);
  drift(grains, 10);
  const Packing after = packing_of(grains);
  for (std::size_t k = 0; k < after.spheres.size(); ++k)
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(after.spheres[k].centre[axis], 0);
      EXPECT_LT(after.spheres[k].centre[axis], 1);
      const double moved = after.spheres[k].centre[axis] - before.spheres[k].centre[axis];
      EXPECT_NEAR(moved, std::round(moved), 1e-12); // by whole boxes
    }
}

TEST(PeriodicGrains, AreFollowedBeyondTheBox) {
  Grains grains = grains_in(all_around, 40, 1);
  const Vec3 moved(0.3, -0.2, 0.4);
  for (Velocity& velocity : grains.velocity)
    velocity.translation = moved;
  const Packing before = packing_of(grains);
  drift(grains, 1);
  const Packing after = packing_near(grains, before);
  for (std::size_t k = 0; k < after.spheres.size(); ++k)
    EXPECT_LT((after.spheres[k].centre - before.spheres[k].centre - moved).norm(), 1e-12);
}

TEST(PeriodicGrains, NeedABoxInWhichNoPairTouchesTwice) {
  const Packing packing{{Vec3::Zero(), Vec3::Ones()}, {{{0.5, 0.5, 0.5}, 0.24}}};
  EXPECT_THROW(grains_of(packing, 1000, {true, false, false}), InputError);
  EXPECT_NO_THROW(grains_of(packing, 1000));
}

} // namespace
