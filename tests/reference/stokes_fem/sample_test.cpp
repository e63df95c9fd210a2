// Pressures and fluxes at places inside flows that are known exactly, then in packings where they must add up.

#include "pfv/pores/pore_network.hpp"
#include "pfv/problem/generate.hpp"
#include "reference/probes.hpp"
#include "reference/stokes_fem/box_mesh.hpp"
#include "reference/stokes_fem/flow_on_mesh.hpp"
#include "reference/stokes_fem/quadratic_cell.hpp"
#include "reference/stokes_fem/stokes_fem.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <unistd.h>

namespace {

using pfv::Vec3;
using reference::Probes;

// Between plates at x = 0 and 0.5, p = z: u_z = - x (0.5 - x) / 2.
reference::Answer between_plates(const Probes& probes) {
  pfv::Case problem;
  problem.packing = {{Vec3::Zero(), Vec3(0.5, 0.7, 1)}, {{{0, 0, 0}, 1e-3}, {{0.5, 0, 0}, 1e-3}}};
  problem.faces = pfv::flow_along(pfv::Axis::z);
  const auto file = std::filesystem::temp_directory_path() / ("plates_" + std::to_string(getpid()) + ".msh");
  write_box_mesh(file, problem.packing.box, {3, 2, 4}, {"sphere_0", "sphere_1", "y_min", "y_max", "z_min", "z_max"});
  pfv::Clock clock;
  auto answer = reference::stokes_fem::flow_on_mesh(problem, file, 0.2, clock, probes);
  std::filesystem::remove(file);
  return answer;
}

Probes::Facet cross_section(double z, double tilt = 0) {
  return {{0, 0, z - tilt}, {0.5, 0, z + tilt}, {0.5, 0.7, z + tilt}, {0, 0.7, z - tilt}};
}

constexpr double tolerance = 1e-8;
const double flux = -0.7 * std::pow(0.5, 3) / 12;

} // namespace

TEST(Sample, PressureIsLinearBetweenPlates) {
  const Probes probes{{{0.1, 0.2, 0.33}, {0.25, 0.35, 0.5}, {0, 0.7, 1}, {0.4, 0.1, 0}, {0.2, 0.2, 1.2}}, {}};
  const auto pressures = *between_plates(probes).point_pressures;
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(pressures[i], probes.points[i].z(), tolerance);
  EXPECT_TRUE(std::isnan(pressures[4])); // outside of the box
}

TEST(Sample, TheSameFlowsThroughEveryCrossSection) {
  Probes probes;
  // Between and along the faces of cells, on both open faces, tilted, half of the width, and against the flow.
  probes.facets = {cross_section(0.4), cross_section(0.5), cross_section(0), cross_section(1), cross_section(0.6, 0.1)};
  probes.facets.push_back({{0, 0, 0.3}, {0.25, 0, 0.3}, {0.25, 0.7, 0.3}, {0, 0.7, 0.3}});
  for (const double z : {0.0, 0.5, 1.0}) {
    auto turned = cross_section(z);
    std::ranges::reverse(turned);
    probes.facets.push_back(turned);
  }
  probes.facets.push_back({{0.1, 0.1, 0}, {0.1, 0.1, 1}, {0.1, 0.6, 1}}); // along the flow
  const auto fluxes = *between_plates(probes).facet_fluxes;
  const std::vector<double> expected{1, 1, 1, 1, 1, 0.5, -1, -1, -1, 0};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(fluxes[i] / flux, expected[i], tolerance) << i;
}

TEST(QuadraticCell, FindsItsWayBack) {
  using reference::stokes_fem::QuadraticCell;
  using reference::stokes_fem::Weights;
  QuadraticCell cell;
  const std::array<Vec3, 4> corners{Vec3(0, 0, 0), Vec3(1, 0.2, 0), Vec3(0.1, 1.1, 0), Vec3(0, 0.3, 0.8)};
  std::ranges::copy(corners, cell.points.begin());
  for (std::size_t edge = 0; edge < 6; ++edge)
    cell.points[4 + edge] = (corners[static_cast<std::size_t>(QuadraticCell::edges[edge].first)] +
                             corners[static_cast<std::size_t>(QuadraticCell::edges[edge].second)]) /
                                2 +
                            0.05 * Vec3(1, -1, 0.5);
  for (int node = 0; node < 10; ++node)
    EXPECT_LT((cell.at(QuadraticCell::node(node)) - cell.points[static_cast<std::size_t>(node)]).norm(), 1e-15);
  const Weights weights(0.1, 0.2, 0.3, 0.4);
  const Vec3 point = cell.at(weights);
  const auto found = cell.weights_of(point, cell.straight_weights(point));
  ASSERT_TRUE(found);
  EXPECT_LT((*found - weights).norm(), 1e-10);
  const auto [lower, upper] = cell.bounds();
  EXPECT_GT((point - lower).minCoeff(), 0);
  EXPECT_GT((upper - point).minCoeff(), 0);
}

namespace {

class SampleOfPacking : public ::testing::Test {
protected:
  void SetUp() override {
    setenv("PFV_MESH_CACHE", TEST_MESH_CACHE, 1);
    if (const auto reason = method->unavailable())
      GTEST_SKIP() << *reason;
  }

  std::unique_ptr<reference::Method> method = reference::make_stokes_fem();
};

} // namespace

TEST_F(SampleOfPacking, WhatEntersAPoreLeavesIt) {
  pfv::Case problem;
  problem.packing = pfv::random_packing({.spheres = 6, .solid_fraction = 0.35, .radius_ratio = 1.5, .seed = 3});
  problem.faces = pfv::flow_along(pfv::Axis::z);
  pfv::Clock clock;
  const auto network = pfv::build_pore_network(problem.packing, {}, clock);
  Probes probes = reference::pore_probes(problem, network).probes;
  const std::size_t throats = probes.facets.size();
  for (const double z : {0.0, 0.21, 0.5, 1.0})
    probes.facets.push_back({{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}});
  const auto answer = method->solve(problem, {.mesh_size = 1.4, .probes = probes}, clock);
  const auto& fluxes = *answer.facet_fluxes;
  const double through = answer.face_flux[4];

  std::vector<double> sum(network.pores.size(), 0);
  std::vector<double> largest(network.pores.size(), 0);
  for (std::size_t t = 0; t < throats; ++t)
    for (const int side : {0, 1}) {
      const auto pore = static_cast<std::size_t>(network.throats.pores[t][static_cast<std::size_t>(side)]);
      sum[pore] += side == 0 ? fluxes[t] : -fluxes[t];
      largest[pore] = std::max(largest[pore], std::abs(fluxes[t]));
    }
  std::vector<bool> is_open(network.pores.size(), false); // touches a pressure face, through which it gains or loses
  for (const auto& part : network.wall_parts)
    if (axis_of(part.face) == pfv::Axis::z)
      is_open[static_cast<std::size_t>(part.pore)] = true;
  std::size_t closed = 0;
  for (std::size_t pore = 0; pore < sum.size(); ++pore)
    if (!is_open[pore]) {
      ++closed;
      EXPECT_LT(std::abs(sum[pore]), 5e-3 * *std::ranges::max_element(largest)) << pore;
    }
  EXPECT_GT(closed, 5U);
  // All facets are cut from one field, so what is left is the field's divergence, of the mesh's own order.
  for (std::size_t section = throats; section < fluxes.size(); ++section)
    EXPECT_NEAR(fluxes[section] / -through, 1, 5e-3);

  double sampling = 0;
  double all = 0;
  for (const auto& stage : answer.stages) {
    all += stage.cpu_seconds;
    if (stage.name == "sample")
      sampling = stage.cpu_seconds;
  }
  EXPECT_GT(sampling, 0);

  const auto& pressures = *answer.point_pressures;
  EXPECT_GT(std::ranges::count_if(pressures, [](double p) { return p > -0.2 && p < 1.2; }),
            static_cast<std::ptrdiff_t>(network.pores.size()) / 2);
}
