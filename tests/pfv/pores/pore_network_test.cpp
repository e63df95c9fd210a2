#include "pfv/pores/pore_network.hpp"

#include "ball_in_cone.hpp"
#include "pfv/pores/power_centre.hpp"
#include "pfv/problem/generate.hpp"
#include "support/packings.hpp"

#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

using namespace pfv;
using pfv::testing::ball_in_cone;
using pfv::testing::BallPart;
using pfv::testing::network_of;
using pfv::testing::packing_from;

namespace {

/// Volume and surface of a sphere inside the box, by its eight octants.
BallPart inside_box(const Sphere& sphere, const Box& box) {
  const auto cuts = wall_cuts(sphere, box);
  BallPart sum;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0}) {
        const auto part = ball_in_cone(sphere.radius, cuts, x * Vec3::UnitX(), y * Vec3::UnitY(), z * Vec3::UnitZ());
        sum.volume += x * y * z * part.volume;
        sum.surface += x * y * z * part.surface;
      }
  return sum;
}

/// What a sphere keeps of itself where others overlap it: all but the caps beyond their radical planes. Exact as long
/// as no three spheres have a point in common and no overlap reaches a wall.
BallPart kept(std::size_t k, const Packing& packing) {
  const Sphere& sphere = packing.spheres[k];
  BallPart part = inside_box(sphere, packing.box);
  for (std::size_t other = 0; other < packing.spheres.size(); ++other) {
    const double apart = (packing.spheres[other].centre - sphere.centre).norm();
    if (other == k || apart >= sphere.radius + packing.spheres[other].radius)
      continue;
    const double squares = std::pow(sphere.radius, 2) - std::pow(packing.spheres[other].radius, 2);
    const double height = sphere.radius - (apart * apart + squares) / (2 * apart);
    part.volume -= std::numbers::pi * height * height * (3 * sphere.radius - height) / 3;
    part.surface -= 2 * std::numbers::pi * sphere.radius * height;
  }
  return part;
}

/// The tiling that everything rests on, to round-off, sphere by sphere.
void expect_tiling(const Packing& packing) {
  const PoreNetwork network = network_of(packing);
  const double box = packing.box.volume();
  EXPECT_NEAR(std::accumulate(network.pores.volume.begin(), network.pores.volume.end(), 0.0) / box, 1, 1e-10);
  double solid = 0;
  for (std::size_t k = 0; k < packing.spheres.size(); ++k) {
    const auto exact = kept(k, packing);
    const double r = packing.spheres[k].radius;
    EXPECT_NEAR(network.spheres.wetted_surface[k], exact.surface, 1e-10 * 4 * std::numbers::pi * r * r) << k;
    EXPECT_NEAR(network.spheres.volume[k], exact.volume, 1e-10 * r * r * r) << k;
    solid += exact.volume;
  }
  EXPECT_NEAR(network.porosity(), 1 - solid / box, 1e-10);
  for (const Face face : all_faces) {
    double area = 0;
    for (const auto& part : network.wall_parts)
      area += part.face == face ? part.area : 0;
    EXPECT_NEAR(area * packing.box.size()[index(axis_of(face))] / box, 1, 1e-10) << face_names[index(face)];
  }
}

TEST(PoreNetwork, TilesRandomPackings) {
  expect_tiling(packing_from("g200.txt"));
  expect_tiling(packing_from("g2000.txt"));
  expect_tiling(random_packing({.spheres = 60, .solid_fraction = .4, .radius_ratio = 5, .seed = 7, .size = 2}));
}

TEST(PoreNetwork, TilesLatticesAndSpheresCutByWalls) {
  expect_tiling(packing_from("bcc9.txt"));
  expect_tiling(packing_from("bcc9jit.txt"));
  for (const auto lattice : {Lattice::simple_cubic, Lattice::bcc, Lattice::fcc}) {
    expect_tiling(lattice_packing(lattice, touching_solid_fraction(lattice), 2));
    expect_tiling(lattice_packing(lattice, 0.2, 1));
  }
  expect_tiling({{{0, 0, 0}, {1, 2, 3}}, {{{.3, .2, .1}, .35}, {{.7, 1.9, 2.8}, .25}, {{.5, 1, 1.5}, .3}}});
}

TEST(PoreNetwork, TilesOverlappingSpheres) {
  for (const double growth : {1.001, 1.02, 1.05, 1.1}) {
    Packing packing = random_packing({.spheres = 100, .solid_fraction = .4, .radius_ratio = 1.5, .seed = 3});
    for (auto& sphere : packing.spheres)
      sphere.radius *= growth;
    expect_tiling(packing);
  }
  expect_tiling({{{0, 0, 0}, {3, 2, 2}}, {{{1, 1, 1}, .6}, {{2, 1, 1}, .6}, {{1.5, .3, 1}, .2}}});
}

TEST(PoreNetwork, TilesOneSphereAndARow) {
  expect_tiling({{{0, 0, 0}, {1, 1, 1}}, {{{.4, .5, .6}, .2}}});
  expect_tiling({{{0, 0, 0}, {3, 1, 1}}, {{{.5, .5, .5}, .5}, {{1.5, .5, .5}, .5}, {{2.5, .5, .5}, .5}}});
}

TEST(PoreNetwork, HasNoNegativeLengths) { // (P_j - P_i).n >= 0 on every facet of a regular triangulation
  const auto network = network_of(packing_from("g2000.txt"));
  for (const double length : network.throats.length)
    EXPECT_GE(length, -1e-6);
}

TEST(PoreNetwork, PutsThePoresOfAWallOnIt) {
  const auto packing = packing_from("g200.txt");
  const auto network = network_of(packing);
  std::size_t touching = 0;
  for (std::size_t i = 0; i < network.pores.size(); ++i)
    if (network.pores.touches(i, Face::y_max)) {
      EXPECT_NEAR(network.pores.centre[i].y(), 1, 1e-12);
      ++touching;
    }
  EXPECT_GT(touching, 20u);
}

TEST(PowerCentre, HasEqualPowerToItsFourVertices) {
  const auto packing = packing_from("g200.txt");
  const auto network = network_of(packing);
  for (std::size_t i = 0; i < network.pores.size(); ++i) {
    std::vector<double> powers;
    for (const Vertex v : network.pores.vertices[i])
      if (!is_wall(v))
        powers.push_back((network.pores.centre[i] - network.sites.spheres[v].centre).squaredNorm() -
                         network.sites.spheres[v].radius * network.sites.spheres[v].radius);
    for (const double power : powers)
      EXPECT_NEAR(power, powers.front(), 1e-12);
  }
}

TEST(PoreNetwork, ReportsSpheresHiddenByOthers) {
  const Packing packing{{{0, 0, 0}, {1, 1, 1}}, {{{.5, .5, .5}, .4}, {{.55, .5, .5}, .05}, {{.2, .2, .2}, .1}}};
  EXPECT_EQ(network_of(packing).hidden_spheres, std::vector<int>{1});
}

} // namespace
