#include "meshing/linear_mesh.hpp"

#include "meshing/read_msh.hpp"
#include "support/message_of.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <stdexcept>

namespace {

using meshing::LinearMesh;
using pfv::testing::message_of;

// Two tetrahedra on either side of a triangle.
LinearMesh two_cells() {
  LinearMesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.1, 0.2, 1.0 / 3}, {0, 0.3, -1}};
  mesh.tetrahedra = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  mesh.surfaces = {"sphere_0", "x_min"};
  mesh.triangles = {{{0, 1, 3}, 0}, {{1, 2, 3}, 0}, {{0, 2, 3}, 1}, {{0, 1, 4}, 0}, {{1, 2, 4}, 0}, {{0, 2, 4}, 1}};
  return mesh;
}

std::string fault(const LinearMesh& mesh) {
  return message_of<std::runtime_error>([&] { meshing::check(mesh); });
}

TEST(LinearMesh, WholeMeshesPass) {
  EXPECT_EQ(fault(two_cells()), "no error");
}

TEST(LinearMesh, FaultsAreFound) {
  auto inverted = two_cells();
  std::swap(inverted.tetrahedra[0][0], inverted.tetrahedra[0][1]);
  EXPECT_NE(fault(inverted).find("inside out"), std::string::npos);

  auto hole = two_cells();
  hole.triangles.pop_back();
  EXPECT_NE(fault(hole).find("1 sides"), std::string::npos);

  auto missing = two_cells();
  missing.tetrahedra.pop_back();
  EXPECT_NE(fault(missing).find("1 sides"), std::string::npos);

  auto inner = two_cells();
  inner.triangles.push_back({{0, 1, 2}, 0});
  EXPECT_NE(fault(inner).find("3 sides"), std::string::npos);
}

TEST(LinearMesh, WritesMshThatReadsBack) {
  const pfv::testing::TemporaryFolder folder;
  const auto mesh = two_cells();
  write_msh(mesh, folder.path() / "mesh.msh");
  const auto found = meshing::testing::read_msh(folder.path() / "mesh.msh");
  EXPECT_EQ(found.nodes, mesh.nodes); // to the last bit
  EXPECT_EQ(found.tetrahedra, mesh.tetrahedra);
  EXPECT_EQ(found.surfaces, mesh.surfaces);
  ASSERT_EQ(found.triangles.size(), mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    EXPECT_EQ(found.triangles[t].nodes, mesh.triangles[t].nodes);
    EXPECT_EQ(found.triangles[t].surface, mesh.triangles[t].surface);
  }
}

TEST(LinearMesh, SaysWhereItCannotWrite) {
  const auto message = message_of<std::runtime_error>([] { write_msh(two_cells(), "/no/such/folder/mesh.msh"); });
  EXPECT_NE(message.find("/no/such/folder"), std::string::npos);
}

} // namespace
