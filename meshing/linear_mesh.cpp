#include "meshing/linear_mesh.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>

namespace meshing {

namespace {

constexpr int triangle_type = 2, tetrahedron_type = 4; // of gmsh

std::array<int, 3> sorted(std::array<int, 3> nodes) {
  std::ranges::sort(nodes);
  return nodes;
}

} // namespace

void check(const LinearMesh& mesh) {
  std::map<std::array<int, 3>, int> sides; // how many of the two sides of a face something lies on
  for (const auto& [a, b, c, d] : mesh.tetrahedra) {
    const pfv::Vec3& origin = mesh.nodes[a];
    if ((mesh.nodes[b] - origin).dot((mesh.nodes[c] - origin).cross(mesh.nodes[d] - origin)) <= 0)
      throw std::runtime_error(
          fmt::format("a tetrahedron at ({:g}, {:g}, {:g}) is flat or inside out", origin.x(), origin.y(), origin.z()));
    for (const auto& face : {std::array{b, c, d}, std::array{a, c, d}, std::array{a, b, d}, std::array{a, b, c}})
      ++sides[sorted(face)];
  }
  for (const auto& triangle : mesh.triangles)
    ++sides[sorted(triangle.nodes)];
  for (const auto& [face, count] : sides)
    if (count != 2) {
      const pfv::Vec3& node = mesh.nodes[face[0]];
      throw std::runtime_error(
          fmt::format("a face at ({:g}, {:g}, {:g}) has {} sides in the mesh", node.x(), node.y(), node.z(), count));
    }
}

void write_msh(const LinearMesh& mesh, const std::filesystem::path& file) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  const std::size_t fluid = mesh.surfaces.size() + 1;
  fmt::format_to(out, "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{}\n", fluid);
  for (std::size_t s = 0; s < mesh.surfaces.size(); ++s)
    fmt::format_to(out, "2 {} \"{}\"\n", s + 1, mesh.surfaces[s]);
  fmt::format_to(out, "3 {} \"fluid\"\n$EndPhysicalNames\n$Nodes\n{}\n", fluid, mesh.nodes.size());
  std::size_t number = 0;
  for (const pfv::Vec3& node : mesh.nodes)
    fmt::format_to(out, "{} {} {} {}\n", ++number, node.x(), node.y(), node.z());
  fmt::format_to(out, "$EndNodes\n$Elements\n{}\n", mesh.triangles.size() + mesh.tetrahedra.size());
  number = 0;
  for (const auto& [n, surface] : mesh.triangles) // number, type, count of tags, physical and elementary tag, nodes
    fmt::format_to(out, "{} {} 2 {} {} {} {} {}\n", ++number, triangle_type, surface + 1, surface + 1, n[0] + 1,
                   n[1] + 1, n[2] + 1);
  for (const auto& n : mesh.tetrahedra)
    fmt::format_to(out, "{} {} 2 {} {} {} {} {} {}\n", ++number, tetrahedron_type, fluid, fluid, n[0] + 1, n[1] + 1,
                   n[2] + 1, n[3] + 1);
  fmt::format_to(out, "$EndElements\n");

  std::ofstream stream(file, std::ios::binary);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream.flush())
    throw std::runtime_error(fmt::format("cannot write {}", file.string()));
}

} // namespace meshing
