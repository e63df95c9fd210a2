#include "reference/stokes_fem/tractions.hpp"

#include "reference/stokes_fem/boundary_faces.hpp"

#include <algorithm>

namespace reference::stokes_fem {

namespace {

using pfv::Vec3;

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

std::vector<double> mean_pressures(const Discretisation& space, const FlowField& flow) {
  std::vector<double> integral(space.labels.size(), 0);
  std::vector<double> area(space.labels.size(), 0);
  auto values = face_values(space, space.linear, value_flags);
  Dofs nodes(4);
  for_each_boundary_face(space, [&](const Cell& cell, unsigned face_number, int label) {
    values.reinit(cell, face_number);
    cell_of(space.pressure, cell)->get_dof_indices(nodes);
    for (const unsigned q : values.quadrature_point_indices()) {
      double pressure = 0;
      for (unsigned k = 0; k < nodes.size(); ++k)
        pressure += flow.pressure[static_cast<Eigen::Index>(nodes[k])] * values.shape_value(k, q);
      integral[static_cast<std::size_t>(label)] += pressure * values.JxW(q);
      area[static_cast<std::size_t>(label)] += values.JxW(q);
    }
  });
  for (std::size_t label = 0; label < area.size(); ++label)
    if (area[label] > 0)
      integral[label] /= area[label];
  return integral;
}

} // namespace reference::stokes_fem
