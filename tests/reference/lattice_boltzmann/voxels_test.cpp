#include "reference/lattice_boltzmann/pockets.hpp"
#include "reference/lattice_boltzmann/velocities.hpp"
#include "reference/lattice_boltzmann/wall_links.hpp"

#include "pfv/problem/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace reference::lattice_boltzmann {
namespace {

FlowQuestion cube(int side, const std::vector<pfv::Sphere>& spheres, Beyond beyond = Beyond::repeats) {
  FlowQuestion question;
  question.voxels.fill(side);
  question.beyond.fill(beyond);
  question.spheres = spheres;
  return question;
}

TEST(Voxels, CountTheVolumeOfASphere) {
  const Voxels voxels(cube(40, {{{20, 20, 20}, 15.3}}));
  const double volume = 4 * std::numbers::pi / 3 * std::pow(15.3, 3);
  EXPECT_NEAR(voxels.solid_counts(1)[0] / volume, 1, 0.01);
  EXPECT_EQ(static_cast<double>(voxels.fluid_count()) + voxels.solid_counts(1)[0], 40 * 40 * 40);
}

TEST(Voxels, OfAPeriodicBoxDoNotCareWhereItBegins) {
  const auto middle = cube(20, {{{10, 10, 10}, 7.2}});
  const auto corner = cube(20, {{{0, 0, 0}, 7.2}});
  EXPECT_EQ(Voxels(middle).fluid_count(), Voxels(corner).fluid_count());
  EXPECT_EQ(wall_links(middle, Voxels(middle)).size(), wall_links(corner, Voxels(corner)).size());
}

TEST(WallLinks, EndOnTheSphere) {
  const auto question = cube(24, {{{11.3, 12.1, 12.4}, 7.7}});
  const Voxels voxels(question);
  const auto links = wall_links(question, voxels);
  EXPECT_GT(links.size(), 1000U);
  for (const auto& link : links) {
    EXPECT_TRUE(voxels.is_fluid(link.voxel));
    EXPECT_GE(link.fraction, 0);
    EXPECT_LE(link.fraction, 1);
    const Step& c = steps[static_cast<std::size_t>(link.direction)];
    const pfv::Vec3 hit = pfv::Vec3(link.voxel[0] + 0.5, link.voxel[1] + 0.5, link.voxel[2] + 0.5) +
                          link.fraction * pfv::Vec3(c[0], c[1], c[2]);
    EXPECT_NEAR((hit - question.spheres[0].centre).norm(), 7.7, 1e-9);
  }
}

// A mirror through the middle of a sphere: the links of its half, those that end beyond the mirror among them.
TEST(WallLinks, SeeTheImageOfAHalfSphere) {
  const auto half = cube(12, {{{6, 6, 0}, 4.3}}, Beyond::is_mirrored);
  const auto whole = cube(24, {{{6, 6, 12}, 4.3}});
  const auto of_whole = wall_links(whole, Voxels(whole));
  std::size_t above = 0;
  for (const auto& link : of_whole)
    above += link.voxel[2] >= 12;
  EXPECT_EQ(wall_links(half, Voxels(half)).size(), above);
}

// Four spheres that touch close a cell around the middle of a face of the box.
TEST(Pockets, AreFilledAndBelongToTheNearestSphere) {
  const double r = 5;
  FlowQuestion question = cube(30, {}, Beyond::is_mirrored);
  for (const double x : {10., 15., 20.})
    for (const double y : {10., 15., 20.})
      for (const double z : {10., 15., 20.})
        if (x != 15 || y != 15 || z != 15)
          question.spheres.push_back({{x, y, z}, r - 0.6});
  Voxels voxels(question);
  EXPECT_TRUE(voxels.is_fluid({15, 15, 15}));
  const auto before = voxels.fluid_count();
  const auto filled = fill_pockets(question, voxels);
  EXPECT_GT(filled, 0U);
  EXPECT_FALSE(voxels.is_fluid({15, 15, 15}));
  EXPECT_EQ(voxels.fluid_count() + filled, before);
  const auto counts = voxels.solid_counts(question.spheres.size());
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0.) + static_cast<double>(voxels.fluid_count()), 27000);
}

TEST(Pockets, ABoxWithoutAWayThroughIsAnError) {
  const FlowQuestion question = cube(10, {{{5, 5, 5}, 9}}, Beyond::is_mirrored);
  Voxels voxels(question);
  EXPECT_THROW(fill_pockets(question, voxels), pfv::SolveError);
}

} // namespace
} // namespace reference::lattice_boltzmann
