#include "reference/stokes_fem/boundary.hpp"

#include "pfv/problem/error.hpp"
#include "reference/stokes_fem/boundary_faces.hpp"

#include <algorithm>
#include <cstdint>

namespace reference::stokes_fem {

namespace {

using pfv::Vec3;

bool holds(const pfv::FaceCondition& condition, pfv::Face face, int component) {
  const bool normal = index(axis_of(face)) == component;
  if (const auto* open = std::get_if<pfv::Pressure>(&condition))
    return !normal && open->tangential == pfv::Tangential::zero;
  return normal && std::holds_alternative<pfv::SlipWall>(condition);
}

struct NodePieces {
  int grain = Boundary::free;                         // label of a sphere, or else of a bridge, the node is on
  std::array<int, 6> face = {-1, -1, -1, -1, -1, -1}; // label of each box face the node is on
};

void put_on(const BoundaryLabel& label, int index, const std::vector<BoundaryLabel>& labels, NodePieces& node) {
  if (const auto* face = std::get_if<BoxFace>(&label))
    node.face[static_cast<std::size_t>(pfv::index(face->face))] = index;
  else if (node.grain == Boundary::free || std::holds_alternative<Bridge>(labels[static_cast<std::size_t>(node.grain)]))
    node.grain = index;
}

int holder_of(const NodePieces& node, const pfv::FaceConditions& faces, int component) {
  if (node.grain != Boundary::free)
    return node.grain;
  int holder = Boundary::free;
  for (const pfv::Face face : pfv::all_faces) {
    const auto f = static_cast<std::size_t>(index(face));
    const bool slip = std::holds_alternative<pfv::SlipWall>(faces[f]);
    if (node.face[f] >= 0 && holds(faces[f], face, component) && (slip || holder == Boundary::free))
      holder = node.face[f];
  }
  return holder;
}

} // namespace

Boundary make_boundary(const Discretisation& space, const pfv::FaceConditions& faces) {
  Boundary boundary;
  boundary.labels = space.labels;
  std::vector<NodePieces> pieces(space.velocity_nodes);
  for (const pfv::Face face : pfv::all_faces)
    if (!std::holds_alternative<pfv::SlipWall>(faces[static_cast<std::size_t>(index(face))]))
      boundary.face_weight[static_cast<std::size_t>(index(face))].setZero(
          static_cast<Eigen::Index>(space.velocity_nodes));

  auto values = face_values(space, space.quadratic, value_flags);
  Dofs nodes(10);
  for_each_boundary_face(space, [&](const Cell& cell, unsigned face_number, int label) {
    for (const auto node : face_nodes(space, cell, face_number))
      put_on(space.labels[static_cast<std::size_t>(label)], label, space.labels, pieces[node]);
    const auto* face = std::get_if<BoxFace>(&space.labels[static_cast<std::size_t>(label)]);
    if (!face)
      return;
    Eigen::VectorXd& weight = boundary.face_weight[static_cast<std::size_t>(index(face->face))];
    if (weight.size() == 0)
      return;
    values.reinit(cell, face_number);
    velocity_nodes(space, cell, nodes);
    for (unsigned i = 0; i < nodes.size(); ++i)
      for (const unsigned q : values.quadrature_point_indices())
        weight[static_cast<Eigen::Index>(nodes[i])] += values.shape_value(i, q) * values.JxW(q);
  });

  for (const pfv::Face face : pfv::all_faces) {
    const Eigen::VectorXd& weight = boundary.face_weight[static_cast<std::size_t>(index(face))];
    const bool open = std::holds_alternative<pfv::Pressure>(faces[static_cast<std::size_t>(index(face))]);
    if (open && !(weight.sum() > 0))
      throw pfv::SolveError("the mesh has no surface on face " +
                            std::string(pfv::face_names[static_cast<std::size_t>(index(face))]) +
                            ", where a pressure is given");
  }
  for (int c = 0; c < 3; ++c) {
    auto& holder = boundary.holder[static_cast<std::size_t>(c)];
    holder.reserve(pieces.size());
    for (const NodePieces& node : pieces)
      holder.push_back(holder_of(node, faces, c));
  }
  return boundary;
}

} // namespace reference::stokes_fem
