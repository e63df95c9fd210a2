#include "meshing/dented_cells.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace {

using meshing::LinearMesh;
using meshing::without_dented_cells;

// A fan of four cells above four corners of a square on a surface, under one node on top. `dented` adds the flat cell
// between the square's two diagonals, so that the surface has the diagonal 1 3 and the fan stands on 0 2.
LinearMesh fan(bool dented, const std::string& bottom) {
  LinearMesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, -0.01}, {1, 1, 0}, {0, 1, -0.01}, {0.5, 0.5, 1}};
  mesh.surfaces = {bottom, "x_min"};
  mesh.tetrahedra = {{0, 1, 2, 4}, {0, 2, 3, 4}};
  mesh.triangles = {{{0, 1, 4}, 1}, {{1, 2, 4}, 1}, {{2, 3, 4}, 1}, {{0, 3, 4}, 1}};
  if (dented) {
    mesh.tetrahedra.push_back({0, 2, 1, 3});
    mesh.triangles.push_back({{0, 1, 3}, 0});
    mesh.triangles.push_back({{1, 2, 3}, 0});
  } else {
    mesh.triangles.push_back({{0, 1, 2}, 0});
    mesh.triangles.push_back({{0, 2, 3}, 0});
  }
  return mesh;
}

std::vector<std::array<int, 3>> faces(const LinearMesh& mesh, int surface) {
  std::vector<std::array<int, 3>> result;
  for (auto [nodes, on] : mesh.triangles)
    if (on == surface) {
      std::ranges::sort(nodes);
      result.push_back(nodes);
    }
  std::ranges::sort(result);
  return result;
}

TEST(DentedCells, AreTakenOffCurvedSurfaces) {
  for (const std::string name : {"sphere_3", "bridge_1_2"}) {
    const auto dented = fan(true, name);
    EXPECT_NO_THROW(meshing::check(dented));
    const auto smooth = without_dented_cells(dented);
    EXPECT_NO_THROW(meshing::check(smooth));
    EXPECT_EQ(smooth.tetrahedra.size(), 2);
    EXPECT_EQ(faces(smooth, 0), faces(fan(false, name), 0));
    EXPECT_EQ(faces(smooth, 1), faces(dented, 1));
  }
}

TEST(DentedCells, MeshesWithoutThemStayAsTheyAre) {
  const auto mesh = fan(false, "sphere_0");
  const auto same = without_dented_cells(mesh);
  EXPECT_EQ(same.tetrahedra, mesh.tetrahedra);
  EXPECT_EQ(same.nodes, mesh.nodes);
  EXPECT_EQ(faces(same, 0), faces(mesh, 0));
}

TEST(DentedCells, CellsInTheCornersOfPlanesAreNone) {
  EXPECT_EQ(without_dented_cells(fan(true, "z_min")).tetrahedra.size(), 3);
}

TEST(DentedCells, CellsBetweenTwoSurfacesAreNone) {
  auto mesh = fan(true, "sphere_0");
  mesh.surfaces.emplace_back("sphere_1");
  mesh.triangles.back().surface = 2;
  EXPECT_EQ(without_dented_cells(mesh).tetrahedra.size(), 3);
}

// The right diagonal is an edge of the boundary already: taking the cell off would pinch the fluid there.
TEST(DentedCells, StayWhereTheFluidWouldBePinched) {
  auto mesh = fan(true, "sphere_0");
  std::erase_if(mesh.tetrahedra, [](const auto& cell) { return cell == std::array{0, 2, 3, 4}; });
  std::erase_if(mesh.triangles, [](const auto& triangle) {
    return triangle.nodes == std::array{2, 3, 4} || triangle.nodes == std::array{0, 3, 4};
  });
  mesh.triangles.push_back({{0, 2, 4}, 1});
  mesh.triangles.push_back({{0, 2, 3}, 1});
  EXPECT_NO_THROW(meshing::check(mesh));
  EXPECT_EQ(without_dented_cells(mesh).tetrahedra.size(), 2);
}

TEST(DentedCells, NodesNobodyUsesAreDropped) {
  auto mesh = fan(false, "sphere_0");
  mesh.nodes.insert(mesh.nodes.begin(), pfv::Vec3(9, 9, 9));
  for (auto& cell : mesh.tetrahedra)
    for (int& node : cell)
      ++node;
  for (auto& triangle : mesh.triangles)
    for (int& node : triangle.nodes)
      ++node;
  const auto found = without_dented_cells(mesh);
  EXPECT_EQ(found.nodes, fan(false, "sphere_0").nodes);
  EXPECT_NO_THROW(meshing::check(found));
}

} // namespace
