// Boxes that repeat themselves: one cell must say what the endless lattice says.
#include "pfv/pores/pore_network.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "support/packings.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

using namespace pfv;
using pfv::testing::network_of;

namespace {

Packing loose(double ratio) {
  return random_packing({.spheres = 120, .solid_fraction = .4, .radius_ratio = ratio, .seed = 5, .size = 2e-3});
}

const std::vector<PeriodicAxes> all_subsets{{true, true, true},  {true, true, false},  {true, false, true},
                                            {false, true, true}, {true, false, false}, {false, false, true}};

void expect_tiling(const Packing& packing, const PeriodicAxes& periodic) {
  const PoreNetwork network = network_of(packing, periodic);
  const auto sum = [](const std::vector<double>& of) { return std::accumulate(of.begin(), of.end(), 0.0); };
  EXPECT_NEAR(sum(network.pores.volume) / packing.box.volume(), 1, 1e-12);
  for (std::size_t k = 0; k < packing.spheres.size(); ++k) {
    const double r = packing.spheres[k].radius;
    EXPECT_NEAR(network.spheres.wetted_surface[k] / (4 * std::numbers::pi * r * r), 1, 1e-10) << k;
  }
  EXPECT_EQ(network.inverted_throats, 0u);
  EXPECT_EQ(network.throats.size(), network.throats.shift.size());
  for (const auto& shift : network.throats.shift)
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_TRUE(periodic[axis] || shift[axis] == 0);
  EXPECT_EQ(network.wall_parts.empty(), periodic == (PeriodicAxes{true, true, true}));
}

TEST(PeriodicBox, IsTiledAlongAnySubsetOfItsAxes) {
  for (const auto& periodic : all_subsets) {
    expect_tiling(loose(1), periodic);
    expect_tiling(loose(4), periodic);
    expect_tiling({{{0, 0, 0}, {1, 2, 3}}, {{{.1, .2, .3}, .1}}}, periodic);
    expect_tiling({{{0, 0, 0}, {.1, .2, .3}}, {{{.01, .02, .03}, .01}, {{.05, .06, .2}, .02}}}, periodic);
  }
}

TEST(PeriodicBox, HoldsLatticesInOneCell) {
  for (const auto& periodic : all_subsets)
    expect_tiling({{}, {{{.5, .5, .5}, .5}}}, periodic);
  const PeriodicAxes all{true, true, true};
  expect_tiling({{}, {{{0, 0, 0}, .4}, {{.5, .5, .5}, .4}}}, all);
  expect_tiling({{}, {{{.25, .25, .25}, .4}, {{.75, .75, .75}, .4}}}, all);
  expect_tiling({{}, {{{0, 0, 0}, .35}, {{.5, .5, 0}, .35}, {{.5, 0, .5}, .35}, {{0, .5, .5}, .35}}}, all);
}

TEST(PeriodicBox, DoesNotDependOnWhereItIsCut) {
  const Packing packing = loose(2);
  Packing moved = packing;
  for (auto& sphere : moved.spheres)
    for (int axis = 0; axis < 3; ++axis)
      sphere.centre[axis] = std::fmod(sphere.centre[axis] + .77e-3 * (axis + 1), 2e-3);
  const auto sorted_areas = [](const Packing& of) {
    auto areas = network_of(of, {true, true, true}).throats.fluid_area;
    std::ranges::sort(areas);
    return areas;
  };
  const auto before = sorted_areas(packing), after = sorted_areas(moved);
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t t = 0; t < before.size(); ++t)
    EXPECT_NEAR(after[t], before[t], 1e-15 * 4e-6 + 1e-10 * before[t]);
}

TEST(PeriodicBox, TooThinForItsLengthIsRefused) {
  const Packing needle{{{0, 0, 0}, {1e-4, 1e-4, 1}}, {{{5e-5, 5e-5, .5}, 4e-5}}};
  EXPECT_THROW(network_of(needle, {true, true, true}), SolveError);
}

} // namespace
