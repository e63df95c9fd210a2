#include "reference/stokes_fem/boundary.hpp"

#include "pfv/problem/error.hpp"
#include "reference/stokes_fem/discretisation.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cstdint>

namespace reference::stokes_fem {

namespace {

using pfv::Vec3;

template <class Visit>
void for_each_boundary_face(const Discretisation& space, const Visit& visit) {
  for (const auto& cell : space.mesh.active_cell_iterators())
    for (const unsigned face : cell->face_indices())
      if (cell->at_boundary(face))
        visit(cell, face, space.label_index.at(cell->face(face)->boundary_id()));
}

Dofs face_nodes(const Discretisation& space, const Cell& cell, unsigned face) {
  Dofs nodes(6);
  cell_of(space.velocity, cell)->face(face)->get_dof_indices(nodes);
  return nodes;
}

bool holds(const pfv::FaceCondition& condition, pfv::Face face, int component) {
  const bool normal = index(axis_of(face)) == component;
  return std::holds_alternative<pfv::SlipWall>(condition) == normal;
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

dealii::FEFaceValues<3> face_values(const Discretisation& space, const dealii::FiniteElement<3>& element,
                                    dealii::UpdateFlags flags) {
  return {*space.mapping, element, dealii::QGaussSimplex<2>(3), flags};
}

const auto value_flags = dealii::update_values | dealii::update_JxW_values;

// The traction on a box face has one unknown part at most: gradient of the component along the normal, less pressure.
class FaceTraction {
public:
  FaceTraction(const Discretisation& space, const pfv::FaceConditions& faces, const FlowField& flow)
      : space_(space), faces_(faces), flow_(flow),
        velocity_(face_values(space, space.quadratic, value_flags | dealii::update_gradients)),
        pressure_(face_values(space, space.linear, dealii::update_values)) {}

  void reinit(const Cell& cell, unsigned face_number, pfv::Face face) {
    velocity_.reinit(cell, face_number);
    pressure_.reinit(cell, face_number);
    cell_of(space_.velocity, cell)->get_dof_indices(nodes_);
    cell_of(space_.pressure, cell)->get_dof_indices(pressures_);
    face_ = face;
  }

  const Dofs& nodes() const { return nodes_; }

  // Integral of the traction's component over the face, tested with the function of local node i.
  double tested(unsigned i, int component) const {
    const pfv::FaceCondition& condition = faces_[static_cast<std::size_t>(index(face_))];
    const bool normal = index(axis_of(face_)) == component;
    const auto* pressure = std::get_if<pfv::Pressure>(&condition);
    if (!pressure && !normal)
      return 0;
    double sum = 0;
    for (const unsigned q : velocity_.quadrature_point_indices())
      sum += (pressure && normal ? -pressure->value * sign() : computed(q, component)) * velocity_.shape_value(i, q) *
             velocity_.JxW(q);
    return sum;
  }

private:
  double sign() const { return is_upper(face_) ? 1 : -1; }

  double computed(unsigned q, int component) const {
    const auto axis = static_cast<unsigned>(index(axis_of(face_)));
    double along_normal = 0;
    for (unsigned j = 0; j < 10; ++j)
      along_normal += flow_.velocity[static_cast<std::size_t>(component)][static_cast<Eigen::Index>(nodes_[j])] *
                      velocity_.shape_grad(j, q)[axis];
    if (static_cast<int>(axis) != component)
      return along_normal * sign();
    double pressure = 0;
    for (unsigned k = 0; k < 4; ++k)
      pressure += flow_.pressure[static_cast<Eigen::Index>(pressures_[k])] * pressure_.shape_value(k, q);
    return (along_normal - pressure) * sign();
  }

  const Discretisation& space_;
  const pfv::FaceConditions& faces_;
  const FlowField& flow_;
  dealii::FEFaceValues<3> velocity_;
  dealii::FEFaceValues<3> pressure_;
  Dofs nodes_ = Dofs(10);
  Dofs pressures_ = Dofs(4);
  pfv::Face face_{};
};

// Simpson's rule is exact for a quadratic. The traction (grad u)^T n of the symmetric stress, integrated over a face,
// is the integral of u.n along its edges; only edges between a pressure face and a slip wall have flow on them.
void add_edge_transfers(const Discretisation& space, const Boundary& boundary, const Cell& cell, unsigned face_number,
                        int label, pfv::Face face, const FlowField& flow, std::vector<Vec3>& transfer) {
  const auto triangle = cell_of(space.velocity, cell)->face(face_number);
  const int along = index(axis_of(face));
  for (unsigned edge = 0; edge < 3; ++edge) {
    Dofs nodes(3);
    triangle->line(edge)->get_dof_indices(nodes);
    const auto middle = static_cast<Eigen::Index>(nodes[2]);
    for (int c = 0; c < 3; ++c) {
      const int wall = boundary.holder[static_cast<std::size_t>(c)][nodes[2]];
      if (c == along || wall == Boundary::free || wall == label)
        continue;
      const auto* wall_face = std::get_if<BoxFace>(&boundary.labels[static_cast<std::size_t>(wall)]);
      if (!wall_face)
        continue;
      const Eigen::VectorXd& u = flow.velocity[static_cast<std::size_t>(along)];
      const double flow_along_edge =
          triangle->line(edge)->measure() / 6 *
          (u[static_cast<Eigen::Index>(nodes[0])] + 4 * u[middle] + u[static_cast<Eigen::Index>(nodes[1])]) *
          (is_upper(face) ? 1 : -1);
      const Vec3 moved = flow_along_edge * outward_normal(wall_face->face);
      transfer[static_cast<std::size_t>(label)] -= moved;
      transfer[static_cast<std::size_t>(wall)] += moved;
    }
  }
}

} // namespace

Boundary make_boundary(const Discretisation& space, const pfv::FaceConditions& faces) {
  Boundary boundary;
  boundary.labels = space.labels;
  std::vector<NodePieces> pieces(space.velocity.n_dofs());
  for (const pfv::Face face : pfv::all_faces)
    if (std::holds_alternative<pfv::Pressure>(faces[static_cast<std::size_t>(index(face))]))
      boundary.face_weight[static_cast<std::size_t>(index(face))].setZero(
          static_cast<Eigen::Index>(space.velocity.n_dofs()));

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
    cell_of(space.velocity, cell)->get_dof_indices(nodes);
    for (unsigned i = 0; i < nodes.size(); ++i)
      for (const unsigned q : values.quadrature_point_indices())
        weight[static_cast<Eigen::Index>(nodes[i])] += values.shape_value(i, q) * values.JxW(q);
  });

  for (const pfv::Face face : pfv::all_faces) {
    const Eigen::VectorXd& weight = boundary.face_weight[static_cast<std::size_t>(index(face))];
    if (weight.size() != 0 && !(weight.sum() > 0))
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

std::vector<Vec3> force_transfers(const Discretisation& space, const Boundary& boundary,
                                  const pfv::FaceConditions& faces, const FlowField& flow) {
  std::vector<Vec3> transfer(boundary.labels.size(), Vec3::Zero());
  FaceTraction traction(space, faces, flow);
  for_each_boundary_face(space, [&](const Cell& cell, unsigned face_number, int label) {
    const auto* face = std::get_if<BoxFace>(&boundary.labels[static_cast<std::size_t>(label)]);
    if (!face)
      return;
    const Dofs on_face = face_nodes(space, cell, face_number);
    traction.reinit(cell, face_number, face->face);
    for (unsigned i = 0; i < traction.nodes().size(); ++i) {
      const auto node = traction.nodes()[i];
      if (std::ranges::find(on_face, node) == on_face.end())
        continue;
      for (int c = 0; c < 3; ++c) {
        const int holder = boundary.holder[static_cast<std::size_t>(c)][node];
        if (holder == label)
          continue;
        const double moved = traction.tested(i, c);
        transfer[static_cast<std::size_t>(label)][c] -= moved;
        if (holder != Boundary::free)
          transfer[static_cast<std::size_t>(holder)][c] += moved;
      }
    }
    if (std::holds_alternative<pfv::Pressure>(faces[static_cast<std::size_t>(index(face->face))]))
      add_edge_transfers(space, boundary, cell, face_number, label, face->face, flow, transfer);
  });
  return transfer;
}

} // namespace reference::stokes_fem
