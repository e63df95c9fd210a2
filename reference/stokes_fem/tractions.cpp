#include "reference/stokes_fem/tractions.hpp"

#include "reference/stokes_fem/boundary_faces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

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
    velocity_nodes(space_, cell, nodes_);
    pressure_nodes(space_, cell, pressures_);
    face_ = face;
  }

  const Dofs& nodes() const { return nodes_; }

  // Integral of the traction's component over the face, tested with the function of local node i.
  double tested(unsigned i, int component) const {
    const pfv::FaceCondition& condition = faces_[static_cast<std::size_t>(index(face_))];
    const bool normal = index(axis_of(face_)) == component;
    const auto* pressure = std::get_if<pfv::Pressure>(&condition);
    const bool zero = !normal && (!pressure || pressure->tangential == pfv::Tangential::free);
    if (zero)
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

// The box face other than `face` that an edge of one of its triangles lies on, if any.
std::optional<pfv::Face> face_beside(const dealii::TriaIterator<dealii::TriaAccessor<1, 3, 3>>& edge, pfv::Face face,
                                     const pfv::Box& box) {
  constexpr double on_plane = 1e-9; // of the unit of length
  for (const pfv::Face other : pfv::all_faces) {
    const auto axis = static_cast<unsigned>(index(axis_of(other)));
    const double plane = (is_upper(other) ? box.upper : box.lower)[axis];
    if (axis_of(other) != axis_of(face) && std::abs(edge->vertex(0)[axis] - plane) < on_plane &&
        std::abs(edge->vertex(1)[axis] - plane) < on_plane)
      return other;
  }
  return std::nullopt;
}

// Simpson's rule is exact for a quadratic. The traction (grad u)^T n of the symmetric stress, integrated over a face,
// is the integral of u.n along its edges; the fluid that flows along an edge between two faces crosses the open one.
void add_edge_transfers(const Discretisation& space, const pfv::Box& box, const std::array<int, 6>& label_of,
                        const Cell& cell, unsigned face_number, pfv::Face face, const FlowField& flow,
                        std::vector<Vec3>& transfer) {
  const auto triangle = cell_of(space.velocity, cell)->face(face_number);
  const Eigen::VectorXd& u = flow.velocity[static_cast<std::size_t>(index(axis_of(face)))];
  for (unsigned edge = 0; edge < 3; ++edge) {
    const auto beside = face_beside(cell->face(face_number)->line(edge), face, box);
    const int other = beside ? label_of[static_cast<std::size_t>(index(*beside))] : -1;
    if (other < 0)
      continue;
    Dofs nodes(3);
    triangle->line(edge)->get_dof_indices(nodes);
    for (auto& node : nodes)
      node = space.velocity_node[node];
    const double flow_along_edge =
        triangle->line(edge)->measure() / 6 *
        (u[static_cast<Eigen::Index>(nodes[0])] + 4 * u[static_cast<Eigen::Index>(nodes[2])] +
         u[static_cast<Eigen::Index>(nodes[1])]) *
        (is_upper(face) ? 1 : -1);
    const Vec3 moved = flow_along_edge * outward_normal(*beside);
    transfer[static_cast<std::size_t>(label_of[static_cast<std::size_t>(index(face))])] -= moved;
    transfer[static_cast<std::size_t>(other)] += moved;
  }
}

// None of periodic faces, where nothing ends.
std::array<int, 6> labels_of_faces(const std::vector<BoundaryLabel>& labels, const pfv::FaceConditions& faces) {
  std::array<int, 6> label_of{};
  label_of.fill(-1);
  for (std::size_t label = 0; label < labels.size(); ++label)
    if (const auto* face = std::get_if<BoxFace>(&labels[label]))
      if (const auto f = static_cast<std::size_t>(index(face->face)); !std::holds_alternative<pfv::Periodic>(faces[f]))
        label_of[f] = static_cast<int>(label);
  return label_of;
}

} // namespace

std::vector<Vec3> force_transfers(const Discretisation& space, const Boundary& boundary, const pfv::Case& problem,
                                  const FlowField& flow) {
  std::vector<Vec3> transfer(boundary.labels.size(), Vec3::Zero());
  const pfv::FaceConditions& faces = problem.faces;
  const std::array<int, 6> label_of = labels_of_faces(boundary.labels, faces);
  FaceTraction traction(space, faces, flow);
  for_each_boundary_face(space, [&](const Cell& cell, unsigned face_number, int label) {
    const auto* face = std::get_if<BoxFace>(&boundary.labels[static_cast<std::size_t>(label)]);
    if (!face || label_of[static_cast<std::size_t>(index(face->face))] < 0)
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
      add_edge_transfers(space, problem.packing.box, label_of, cell, face_number, face->face, flow, transfer);
  });
  return transfer;
}

std::vector<SurfacePressure> surface_pressures(const Discretisation& space, const FlowField& flow,
                                               const pfv::Vec3& gradient, const pfv::Vec3& middle) {
  std::vector<SurfacePressure> sums(space.labels.size());
  auto values =
      face_values(space, space.linear, value_flags | dealii::update_quadrature_points | dealii::update_normal_vectors);
  Dofs nodes(4);
  for_each_boundary_face(space, [&](const Cell& cell, unsigned face_number, int label) {
    values.reinit(cell, face_number);
    pressure_nodes(space, cell, nodes);
    SurfacePressure& sum = sums[static_cast<std::size_t>(label)];
    for (const unsigned q : values.quadrature_point_indices()) {
      const auto& at = values.quadrature_point(q);
      const auto& normal = values.normal_vector(q);
      const double rise = gradient.dot(Vec3(at[0], at[1], at[2]) - middle);
      double pressure = rise;
      for (unsigned k = 0; k < nodes.size(); ++k)
        pressure += flow.pressure[static_cast<Eigen::Index>(nodes[k])] * values.shape_value(k, q);
      const Vec3 area = values.JxW(q) * Vec3(normal[0], normal[1], normal[2]);
      sum.integral += pressure * values.JxW(q);
      sum.area += values.JxW(q);
      sum.area_vector += area;
      sum.push_of_rise += rise * area;
      sum.push_of_flow += (pressure - rise) * area;
    }
  });
  return sums;
}

} // namespace reference::stokes_fem
