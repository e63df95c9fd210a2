#include "meshing/periodic_faces.hpp"

#include "meshing/matching_points.hpp"
#include "pfv/problem/face.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>
#include <stdexcept>

namespace meshing {

namespace {

using Corners = std::array<int, 3>;

Corners sorted(Corners corners) {
  std::ranges::sort(corners);
  return corners;
}

std::set<Corners> triangles_on(const LinearMesh& mesh, pfv::Face face) {
  std::set<Corners> triangles;
  for (const auto& [nodes, surface] : mesh.triangles)
    if (mesh.surfaces[static_cast<std::size_t>(surface)] == pfv::face_names[pfv::index(face)])
      triangles.insert(sorted(nodes));
  return triangles;
}

std::vector<int> nodes_of(const std::set<Corners>& triangles) {
  std::set<int> nodes;
  for (const Corners& corners : triangles)
    nodes.insert(corners.begin(), corners.end());
  return {nodes.begin(), nodes.end()};
}

void align(LinearMesh& mesh, pfv::Axis axis, double length, double tolerance) {
  const auto below = triangles_on(mesh, pfv::lower_face(axis));
  const auto above = triangles_on(mesh, pfv::upper_face(axis));
  const auto below_nodes = nodes_of(below);
  const auto above_nodes = nodes_of(above);
  const auto positions = [&](const std::vector<int>& nodes, double shift) {
    std::vector<pfv::Vec3> list;
    for (const int node : nodes)
      list.push_back(mesh.nodes[static_cast<std::size_t>(node)] + shift * pfv::Vec3::Unit(pfv::index(axis)));
    return list;
  };
  const auto match = matching_points(positions(above_nodes, -length), positions(below_nodes, 0), tolerance);
  std::map<int, int> opposite;
  for (std::size_t i = 0; i < match.size(); ++i) {
    if (match[i] < 0)
      throw std::runtime_error(
          fmt::format("a node on {} has none opposite", pfv::face_names[pfv::index(pfv::upper_face(axis))]));
    opposite[above_nodes[i]] = below_nodes[static_cast<std::size_t>(match[i])];
  }
  std::set<Corners> lowered;
  for (const auto& [a, b, c] : above)
    lowered.insert(sorted({opposite.at(a), opposite.at(b), opposite.at(c)}));
  if (lowered != below)
    throw std::runtime_error(fmt::format("the meshes of {} and {} do not match",
                                         pfv::face_names[pfv::index(pfv::lower_face(axis))],
                                         pfv::face_names[pfv::index(pfv::upper_face(axis))]));
  for (const auto& [node, other] : opposite)
    for (int across = 0; across < 3; ++across)
      if (across != pfv::index(axis))
        mesh.nodes[static_cast<std::size_t>(node)][across] = mesh.nodes[static_cast<std::size_t>(other)][across];
}

} // namespace

void align_periodic_faces(LinearMesh& mesh, const pfv::Box& box, const pfv::PeriodicAxes& periodic, double tolerance) {
  for (const pfv::Axis axis : {pfv::Axis::x, pfv::Axis::y, pfv::Axis::z})
    if (periodic[static_cast<std::size_t>(pfv::index(axis))])
      align(mesh, axis, box.size()[pfv::index(axis)], tolerance);
}

} // namespace meshing
