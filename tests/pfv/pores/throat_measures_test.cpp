// The block form of the geometry against the one-by-one form, and both against what they must sum to.
#include "pfv/pores/throat_measures.hpp"

#include "pfv/pores/facet.hpp"
#include "pfv/pores/pore_network.hpp"
#include "pfv/pores/power_centre.hpp"
#include "pfv/pores/throat_planes.hpp"
#include "pfv/problem/generate.hpp"
#include "support/packings.hpp"

#include <gtest/gtest.h>
#include <numbers>

using namespace pfv;
using pfv::testing::network_of;
using pfv::testing::packing_from;

namespace {

ThroatMeasures one_by_one(const PoreNetwork& network, std::size_t t) {
  return measure_throat(network.walls, network.sites.spheres, network.corners(t),
                        network.pores.centre[network.throats.pores[t][0]], network.centre_ahead(t));
}

Packing grown(double growth, double ratio) {
  Packing packing =
      random_packing({.spheres = 150, .solid_fraction = .4, .radius_ratio = ratio, .seed = 11, .size = .01});
  for (auto& sphere : packing.spheres)
    sphere.radius *= growth;
  return packing;
}

TEST(ThroatMeasures, HaveOpeningsWhenAskedTheSameInBlocks) {
  const PoreNetwork without = network_of(packing_from("g200.txt"));
  EXPECT_TRUE(without.throats.area.empty() && without.throats.gap.empty() && without.throats.contrast.empty());
  for (const Packing& packing : {packing_from("g200.txt"), grown(1.1, 1.5), grown(1, 20)}) {
    const PoreNetwork network = network_of(packing, {}, true);
    const double side = packing.box.size().x();
    std::size_t touching = 0;
    for (std::size_t t = 0; t < network.throats.size(); ++t) {
      const auto corners = network.corners(t);
      EXPECT_NEAR(network.throats.area[t], one_by_one(network, t).plane.area, 1e-13 * side * side);
      EXPECT_NEAR(network.throats.gap[t], smallest_gap(network.walls, network.sites.spheres, corners), 1e-14);
      touching += network.throats.gap[t] == 0;
      const auto [i, j] = network.throats.pores[t];
      for (const Vertex v : corners) // any of its spheres
        if (!is_wall(v))
          EXPECT_NEAR(network.throats.contrast[t],
                      pore_contrast(network.sites.spheres[v], network.pores.centre[i], network.pores.centre[j]), 1e-6);
    }
    EXPECT_LT(touching, network.throats.size());
  }
}

TEST(ThroatMeasures, HaveTheSmallestGapToAnotherSphereOrItsMirrorImage) {
  const Box box{Vec3(0, 0, 0), Vec3(10, 10, 10)};
  const std::vector<Sphere> spheres{{Vec3(2, 2, 2), 1}, {Vec3(5, 2, 2), 1}, {Vec3(2, 6, 2), 2}};
  EXPECT_DOUBLE_EQ(smallest_gap(box, spheres, {0, 1, 2}), .25);                           // 4 - 1 - 2 of 4
  EXPECT_DOUBLE_EQ(smallest_gap(box, spheres, {0, 1, wall_vertex(Face::y_min)}), 1. / 3); // 3 - 2 of 3
  EXPECT_DOUBLE_EQ(smallest_gap(box, spheres, {1, 2, wall_vertex(Face::z_min)}), 0);      // the third touches it
}

TEST(ThroatMeasures, HaveTheContrastOfTheirPores) {
  const Sphere sphere{Vec3(1, 0, 0), 3};
  EXPECT_DOUBLE_EQ(pore_contrast(sphere, Vec3(6, 0, 0), Vec3(1, 5, 0)), 0);      // 16 of each
  EXPECT_DOUBLE_EQ(pore_contrast(sphere, Vec3(6, 0, 0), Vec3(1, 5, 4)), 1. / 3); // 16 and 32
  EXPECT_DOUBLE_EQ(pore_contrast(sphere, Vec3(4, 0, 0), Vec3(1, 3, 0)), 0);      // none of either
  EXPECT_DOUBLE_EQ(pore_contrast(sphere, Vec3(2, 0, 0), Vec3(6, 0, 0)), 1);      // one inside a sphere
}

TEST(ThroatMeasures, AreTheSameInBlocks) {
  for (const Packing& packing :
       {packing_from("g200.txt"), grown(1, 1), grown(1.1, 1.5), grown(1, 20), grown(1.1, 20), grown(1.3, 1.5)}) {
    const PoreNetwork network = network_of(packing);
    const double side = packing.box.size().x();
    for (std::size_t t = 0; t < network.throats.size(); ++t) {
      const ThroatMeasures throat = one_by_one(network, t);
      EXPECT_NEAR(network.throats.fluid_area[t], throat.plane.fluid_area, 1e-13 * side * side);
      EXPECT_NEAR(network.throats.length[t], throat.length, 1e-12 * side);
      EXPECT_NEAR(network.throats.void_volume[t], throat.behind.void_volume + throat.ahead.void_volume,
                  1e-12 * side * side * side);
      double wetted = 0;
      for (int c = 0; c < 3; ++c) {
        wetted += is_wall(network.corners(t)[c]) ? 0 : throat.wetted[c];
        EXPECT_NEAR(network.throats.wetted_parts[t][c], throat.wetted[c],
                    1e-7 * std::abs(throat.wetted[c]) + 1e-12 * side * side);
      }
      EXPECT_NEAR(network.throats.wetted_surface[t], wetted, 1e-12 * side * side);
    }
    visit_planes(network, [&](std::size_t t, const ThroatPlane& plane) {
      const ThroatPlane other = measure_plane(network.walls, network.sites.spheres, network.corners(t));
      EXPECT_NEAR(plane.area, other.area, 1e-13 * side * side);
      EXPECT_NEAR((plane.normal - other.normal).norm(), 0, 1e-9);
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(plane.sector[c], other.sector[c], 1e-13 * side * side);
    });
  }
}

TEST(ThroatMeasures, CoverNoMoreThanTheFacet) { // lenses and reaches included, and discs in one point
  for (const double ratio : {1.0, 5.0, 20.0})
    for (const double growth : {1.0, 1.04, 1.1, 1.3, 1.6}) {
      const PoreNetwork network = network_of(grown(growth, ratio));
      visit_planes(network, [&](std::size_t t, const ThroatPlane& plane) {
        EXPECT_LE(plane.sector[0] + plane.sector[1] + plane.sector[2], (1 + 1e-12) * plane.area + 1e-18) << t;
        for (const double part : plane.sector)
          EXPECT_GE(part, -1e-18);
      });
    }
}

/// Wall less the discs in which it cuts spheres.
double free_wall(const Packing& packing, Face face) {
  const int axis = index(axis_of(face));
  double area = packing.box.volume() / packing.box.size()[axis];
  for (const auto& [centre, radius] : packing.spheres) {
    const double distance =
        is_upper(face) ? packing.box.upper[axis] - centre[axis] : centre[axis] - packing.box.lower[axis];
    if (distance < radius)
      area -= std::numbers::pi * (radius - distance) * (radius + distance);
  }
  return area;
}

TEST(ThroatMeasures, GiveEveryWallItsWettedSurface) {
  const Packing cut{{{0, 0, 0}, {1, 2, 3}}, {{{.6, .5, .1}, .2}, {{.7, 1.5, 2.8}, .25}, {{.5, 1, 1.5}, .3}}};
  for (const Packing& packing : {packing_from("g200.txt"), grown(1, 3), cut}) {
    const PoreNetwork network = network_of(packing);
    std::array<double, 6> wetted{};
    for (std::size_t t = network.throats.interior; t < network.throats.size(); ++t)
      for (int c = 0; c < 3; ++c)
        if (const Vertex v = network.corners(t)[c]; is_wall(v))
          wetted[index(face_of(v))] += network.throats.wetted_parts[t][c];
    for (const Face face : all_faces)
      EXPECT_NEAR(wetted[index(face)] / free_wall(packing, face), 1, 1e-6) << face_names[index(face)];
  }
}

} // namespace
