#include "pfv/grains/candidates.hpp"

#include "pfv/problem/generate.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace pfv;

namespace {

std::set<std::pair<int, int>> pairs_of(const CandidatePairs& pairs) {
  std::set<std::pair<int, int>> found;
  for (std::size_t i = 0; i + 1 < pairs.start.size(); ++i)
    for (int e = pairs.start[i]; e < pairs.start[i + 1]; ++e)
      EXPECT_TRUE(found.emplace(static_cast<int>(i), pairs.other[e]).second);
  return found;
}

std::set<std::pair<int, int>> by_brute_force(const Grains& grains, double margin, double share = 0) {
  std::set<std::pair<int, int>> found;
  for (int i = 0; i < static_cast<int>(grains.size()); ++i)
    for (int j = i + 1; j < static_cast<int>(grains.size()); ++j) {
      const Sphere &a = grains.sphere(i), &b = grains.sphere(j);
      if ((a.centre - b.centre).norm() < a.radius + b.radius + margin + share * std::min(a.radius, b.radius))
        found.emplace(i, j);
    }
  return found;
}

TEST(CandidatePairs, AreAllThatAreNearAtAnySizeRatio) {
  for (const double ratio : {1.0, 5.0, 20.0}) {
    const Grains grains =
        grains_of(random_packing({.spheres = 400, .solid_fraction = 0.3, .radius_ratio = ratio, .seed = 3}), 1000);
    const double margin = 0.3 * grains.packing.spheres.back().radius;
    EXPECT_EQ(pairs_of(candidate_pairs(grains, margin)), by_brute_force(grains, margin)) << ratio;
    EXPECT_EQ(pairs_of(candidate_pairs(grains, margin, {}, 0.7)), by_brute_force(grains, margin, 0.7)) << ratio;
  }
}

TEST(CandidatePairs, AreFoundForGrainsOutsideOfTheBox) {
  Grains grains = grains_of(random_packing({.spheres = 60, .solid_fraction = 0.3}), 1000);
  for (Sphere& sphere : grains.packing.spheres)
    sphere.centre += Vec3(0.4, -0.3, 0.7);
  EXPECT_EQ(pairs_of(candidate_pairs(grains, 0.05)), by_brute_force(grains, 0.05));
}

TEST(CandidatePairs, KeepTheirSpringsAndDistantBonds) {
  Grains grains = grains_of(random_packing({.spheres = 200, .solid_fraction = 0.4}), 1000);
  CandidatePairs before = candidate_pairs(grains, 0.05);
  for (std::size_t e = 0; e < before.other.size(); ++e) {
    before.shear[e] = Vec3::Constant(static_cast<double>(e + 1));
    before.bond[e] = e % 2 == 0 ? Bond::cemented : Bond::touching;
  }
  const CandidatePairs after = candidate_pairs(grains, 1e-9, before);
  std::size_t cemented = 0;
  for (std::size_t i = 0; i < grains.size(); ++i)
    for (int e = after.start[i]; e < after.start[i + 1]; ++e)
      for (int old = before.start[i]; old < before.start[i + 1]; ++old)
        if (before.other[old] == after.other[e]) {
          EXPECT_EQ(after.shear[e], before.shear[old]);
          cemented += after.bond[e] == Bond::cemented;
        }
  EXPECT_EQ(cemented, (before.other.size() + 1) / 2);
}

TEST(CandidatePairs, GrowInProportionToTheGrains) {
  const auto per_grain = [](int spheres) {
    const Grains grains = grains_of(random_packing({.spheres = spheres, .solid_fraction = 0.5}), 1000);
    const double margin = 0.1 * grains.packing.spheres.front().radius;
    return static_cast<double>(candidate_pairs(grains, margin).other.size()) / spheres;
  };
  EXPECT_NEAR(per_grain(4000) / per_grain(500), 1, 0.15);
}

} // namespace
