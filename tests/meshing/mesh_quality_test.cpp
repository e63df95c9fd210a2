#include "meshing/mesh_quality.hpp"

#include "meshing/measure_mesh.hpp"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <stdexcept>

namespace {

using meshing::tetrahedron_quality;
using pfv::Vec3;

TEST(MeshQuality, RegularTetrahedronIsOne) {
  const std::array<Vec3, 4> regular{Vec3(1, 1, 1), Vec3(-1, 1, -1), Vec3(1, -1, -1), Vec3(-1, -1, 1)};
  EXPECT_NEAR(tetrahedron_quality(regular), 1, 1e-14);
  auto small = regular;
  for (Vec3& corner : small)
    corner *= 1e-6;
  EXPECT_NEAR(tetrahedron_quality(small), 1, 1e-14);
  std::swap(small[0], small[1]);
  EXPECT_NEAR(tetrahedron_quality(small), -1, 1e-14);
}

TEST(MeshQuality, CornerOfACube) {
  // Inradius 1 / (3 + sqrt 3), circumradius sqrt 3 / 2.
  EXPECT_NEAR(tetrahedron_quality({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}),
              6 / (3 + std::numbers::sqrt3) / std::numbers::sqrt3, 1e-14);
}

TEST(MeshQuality, FlatTetrahedronIsZero) {
  EXPECT_EQ(tetrahedron_quality({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0)}), 0);
}

TEST(MeshQuality, MeasuresAgainstThePacking) {
  meshing::LinearMesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.tetrahedra = {{0, 1, 2, 3}};
  mesh.surfaces = {"bridge_0_1", "sphere_0", "x_min", "bridge_0_x_max"};
  mesh.triangles = {{{0, 1, 2}, 0}, {{0, 1, 3}, 1}, {{0, 2, 3}, 2}, {{1, 2, 3}, 3}};
  pfv::Packing packing;
  packing.spheres = {{{0.5, 0.5, 0.5}, 0.25}};
  const auto quality = measure_mesh(mesh, packing);
  EXPECT_EQ(quality.nodes, 4);
  EXPECT_EQ(quality.tetrahedra, 1);
  EXPECT_EQ(quality.bridges, 2);
  EXPECT_NEAR(quality.volume, 1.0 / 6, 1e-15);
  EXPECT_NEAR(quality.exact_volume, 1 - 4 * std::numbers::pi / 3 / 64, 1e-9);
  EXPECT_NEAR(quality.volume_error, quality.volume / quality.exact_volume - 1, 1e-15);
  EXPECT_NEAR(quality.surface, 0.5, 1e-15);
  EXPECT_NEAR(quality.exact_surface, 4 * std::numbers::pi / 16, 1e-9);
  EXPECT_NEAR(quality.surface_error, quality.surface / quality.exact_surface - 1, 1e-15);
}

TEST(MeshQuality, JsonReadsBackToTheSame) {
  const meshing::MeshQuality quality{.nodes = 1000000007,
                                     .tetrahedra = 2,
                                     .volume = 1.0 / 3,
                                     .exact_volume = 0.1,
                                     .volume_error = -1e-17,
                                     .surface = 1e300,
                                     .exact_surface = 5e-324,
                                     .surface_error = 0,
                                     .bridges = 7,
                                     .parts = 1,
                                     .enclosed_parts = 3,
                                     .worst_quality = 0.1};
  EXPECT_EQ(meshing::mesh_quality_from_json(to_json(quality)), quality);
}

TEST(MeshQuality, OtherTextIsRefused) {
  for (const char* text : {"", "{", "[]", "{\"nodes\": 1}", "{\"nodes\": \"many\"}"})
    EXPECT_THROW(meshing::mesh_quality_from_json(text), std::runtime_error) << text;
}

} // namespace
