#include "meshing/dented_cells.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace meshing {

namespace {

using Edge = std::array<int, 2>;
using Face = std::array<int, 3>;

template <std::size_t N>
std::array<int, N> sorted(std::array<int, N> nodes) {
  std::ranges::sort(nodes);
  return nodes;
}

/// The face opposite to a corner.
Face face_of(const std::array<int, 4>& cell, int corner) {
  Face face{};
  std::ranges::copy_if(cell, face.begin(), [&](int node) { return node != cell[static_cast<std::size_t>(corner)]; });
  return sorted(face);
}

std::array<Edge, 3> edges_of(const Face& face) {
  return {sorted(Edge{face[0], face[1]}), sorted(Edge{face[0], face[2]}), sorted(Edge{face[1], face[2]})};
}

/// The boundary of the mesh while cells are taken off it.
class Boundary {
public:
  explicit Boundary(const LinearMesh& mesh) {
    for (const auto& [nodes, surface] : mesh.triangles)
      add(sorted(nodes), surface);
    for (const std::string& name : mesh.surfaces)
      is_curved_.push_back(name.starts_with("sphere_") || name.starts_with("bridge_"));
  }

  /// Takes a dented cell off; false when it is none.
  bool take_off(const std::array<int, 4>& cell) {
    std::vector<Face> outer, inner;
    std::optional<int> surface;
    for (int corner = 0; corner < 4; ++corner) {
      const Face face = face_of(cell, corner);
      const auto found = surface_.find(face);
      (found == surface_.end() ? inner : outer).push_back(face);
      if (found == surface_.end())
        continue;
      if (!is_curved_[static_cast<std::size_t>(found->second)] || surface.value_or(found->second) != found->second)
        return false;
      surface = found->second;
    }
    if (outer.size() < 2 || inner.empty())
      return false;
    if (inner.size() == 2 && triangles_at_.contains(common_edge(inner[0], inner[1])))
      return false;
    for (const Face& face : outer)
      remove(face);
    for (const Face& face : inner)
      add(face, *surface);
    return true;
  }

  std::vector<LinearMesh::Triangle> triangles() const {
    std::vector<LinearMesh::Triangle> result;
    for (const auto& [face, surface] : surface_)
      result.push_back({face, surface});
    std::ranges::stable_sort(result, {}, &LinearMesh::Triangle::surface);
    return result;
  }

private:
  static Edge common_edge(const Face& a, const Face& b) {
    Edge edge{};
    std::ranges::set_intersection(a, b, edge.begin());
    return edge;
  }
  void add(const Face& face, int surface) {
    surface_[face] = surface;
    for (const Edge& edge : edges_of(face))
      ++triangles_at_[edge];
  }
  void remove(const Face& face) {
    surface_.erase(face);
    for (const Edge& edge : edges_of(face))
      if (--triangles_at_[edge] == 0)
        triangles_at_.erase(edge);
  }

  std::map<Face, int> surface_;
  std::map<Edge, int> triangles_at_;
  std::vector<bool> is_curved_;
};

void drop_unused_nodes(LinearMesh& mesh) {
  std::vector<int> number(mesh.nodes.size(), -1);
  for (const auto& cell : mesh.tetrahedra)
    for (const int node : cell)
      number[static_cast<std::size_t>(node)] = 0;
  std::vector<pfv::Vec3> used;
  for (std::size_t n = 0; n < number.size(); ++n)
    if (number[n] == 0) {
      number[n] = static_cast<int>(used.size());
      used.push_back(mesh.nodes[n]);
    }
  mesh.nodes = std::move(used);
  const auto renumber = [&](auto& nodes) {
    for (int& node : nodes)
      node = number[static_cast<std::size_t>(node)];
  };
  for (auto& cell : mesh.tetrahedra)
    renumber(cell);
  for (auto& triangle : mesh.triangles)
    renumber(triangle.nodes);
}

} // namespace

LinearMesh without_dented_cells(LinearMesh mesh) {
  Boundary boundary(mesh);
  while (std::erase_if(mesh.tetrahedra, [&](const auto& cell) { return boundary.take_off(cell); }) > 0)
    ;
  mesh.triangles = boundary.triangles();
  drop_unused_nodes(mesh);
  return mesh;
}

} // namespace meshing
