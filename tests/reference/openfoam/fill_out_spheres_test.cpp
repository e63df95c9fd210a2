#include "reference/openfoam/fill_out_spheres.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace reference::openfoam {
namespace {

using Triangle = std::array<std::size_t, 3>;

// A sphere of radius 0.3 as an octahedron refined `levels` times, points on the sphere.
struct Facets {
  std::vector<pfv::Vec3> points;
  std::vector<Triangle> triangles;
};

constexpr double radius = 0.3;
const pfv::Vec3 centre(0.5, 0.5, 0.5);

Facets facets(int levels) {
  Facets sphere;
  for (const double side : {1.0, -1.0})
    for (int axis = 0; axis < 3; ++axis)
      sphere.points.push_back(centre + side * radius * pfv::Vec3::Unit(axis));
  for (const std::size_t x : {0U, 3U})
    for (const std::size_t y : {1U, 4U})
      for (const std::size_t z : {2U, 5U})
        sphere.triangles.push_back((x + y + z) % 2 == 1 ? Triangle{x, y, z} : Triangle{y, x, z});
  for (; levels > 0; --levels) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t a, std::size_t b) {
      const auto [found, added] = middles.try_emplace(std::minmax(a, b), sphere.points.size());
      if (added)
        sphere.points.push_back(centre + radius * (sphere.points[a] + sphere.points[b] - 2 * centre).normalized());
      return found->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : sphere.triangles) {
      const std::size_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c}, Triangle{ab, bc, ca}});
    }
    sphere.triangles = finer;
  }
  return sphere;
}

// One tetrahedron inside each facet, all meeting at the centre: cells on the wrong side of the sphere, but a valid
// mesh.
FoamMesh ball(int levels, const std::string& patch = "sphere_0") {
  const Facets sphere = facets(levels);
  FoamMesh mesh;
  mesh.points = sphere.points;
  mesh.points.push_back(centre);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> first_cell;
  for (std::size_t cell = 0; cell < sphere.triangles.size(); ++cell)
    for (int edge = 0; edge < 3; ++edge) {
      const auto a = sphere.triangles[cell][static_cast<std::size_t>(edge)];
      const auto b = sphere.triangles[cell][static_cast<std::size_t>((edge + 1) % 3)];
      const auto [found, added] = first_cell.try_emplace(std::minmax(a, b), cell);
      if (added)
        continue;
      mesh.add_face(Triangle{a, b, mesh.points.size() - 1});
      mesh.owner.push_back(found->second);
      mesh.neighbour.push_back(cell);
    }
  mesh.patches.push_back({patch, patch_named(patch), mesh.faces(), sphere.triangles.size()});
  for (std::size_t cell = 0; cell < sphere.triangles.size(); ++cell) {
    mesh.add_face(sphere.triangles[cell]);
    mesh.owner.push_back(cell);
  }
  mesh.cell_centres = cell_centres(mesh);
  return mesh;
}

const pfv::Packing packing{{}, {{centre, radius}}};
const double exact_volume = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;

double volume_error(const FoamMesh& mesh) {
  return std::abs(volume(mesh) / exact_volume - 1);
}

TEST(FillOutSpheres, TakesOutMostOfTheVolumeErrorOfFacets) {
  FoamMesh mesh = ball(2);
  const double before = volume_error(mesh);
  EXPECT_EQ(fill_out_spheres(mesh, packing), mesh.points.size() - 1);
  EXPECT_LT(volume_error(mesh), before / 10);
}

// The volume error of facets is of order h^2; what is left is of order h^4.
TEST(FillOutSpheres, LeavesAnErrorOfHigherOrder) {
  std::array<double, 2> left{};
  for (const int level : {2, 3}) {
    FoamMesh mesh = ball(level);
    fill_out_spheres(mesh, packing);
    left[static_cast<std::size_t>(level - 2)] = volume_error(mesh);
  }
  EXPECT_GT(std::log2(left[0] / left[1]), 3);
}

TEST(FillOutSpheres, LeavesBridgesAlone) {
  FoamMesh mesh = ball(2, "bridge_0_1");
  const auto before = mesh.points;
  EXPECT_EQ(fill_out_spheres(mesh, packing), 0U);
  EXPECT_EQ(mesh.points, before);
}

TEST(FillOutSpheres, KeepsPointsOfABoxFaceOnIt) {
  FoamMesh mesh = ball(2);
  pfv::Packing cut = packing;
  cut.box.lower.x() = centre.x(); // the box ends at the sphere's equator
  const auto before = mesh.points;
  fill_out_spheres(mesh, cut);
  for (std::size_t k = 0; k < before.size(); ++k)
    if (before[k].x() == centre.x()) {
      EXPECT_EQ(mesh.points[k].x(), centre.x());
    }
}

} // namespace
} // namespace reference::openfoam
