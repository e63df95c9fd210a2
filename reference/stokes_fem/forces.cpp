#include "reference/stokes_fem/forces.hpp"

#include "reference/stokes_fem/bridge_gaps.hpp"

#include <map>
#include <tuple>

namespace reference::stokes_fem {

namespace {

using pfv::Vec3;

std::vector<Vec3> held_residuals(const StokesSystem& system, const Boundary& boundary, const Vec3& gradient,
                                 const FlowField& flow) {
  std::vector<Vec3> sum(boundary.labels.size(), Vec3::Zero());
  for (std::size_t c = 0; c < 3; ++c) {
    Eigen::VectorXd residual = system.laplacian.selfadjointView<Eigen::Lower>() * flow.velocity[c];
    residual -= system.divergence[c].transpose() * flow.pressure;
    residual += gradient[static_cast<int>(c)] * system.node_volume;
    for (std::size_t node = 0; node < boundary.holder[c].size(); ++node)
      if (const int holder = boundary.holder[c][node]; holder != Boundary::free)
        sum[static_cast<std::size_t>(holder)][static_cast<int>(c)] += residual[static_cast<Eigen::Index>(node)];
  }
  return sum;
}

/// A contact whose bridge the mesh may hold in parts, one at each periodic face that cuts it.
struct Contact {
  Bridge bridge; // of one of the parts, its ends in the order of all
  double area = 0;
  double pressure = 0; // integral over the sides, as seen from the first sphere's own box
};

/// Adds the force on a piece of boundary to whom it belongs.
class Shares {
public:
  Shares(const pfv::Case& problem, const meshing::ImagedPacking& imaged, double bridge_radius)
      : problem_(problem), imaged_(imaged), gradient_(imposed_gradient(problem.faces)), bridge_radius_(bridge_radius) {
    std::size_t originals = 0;
    while (originals < imaged.original.size() && imaged.original[originals] == originals)
      ++originals;
    forces.sphere.assign(originals, Vec3::Zero());
    forces.viscous.assign(originals, Vec3::Zero());
    forces.wall.fill(Vec3::Zero());
  }

  void add(const BoundaryLabel& label, const Vec3& force, const SurfacePressure& surface) {
    force_ = force;
    surface_ = surface;
    std::visit([&](const auto& piece) { add_piece(piece); }, label);
  }

  /// Once all pieces are in.
  void close_gaps() {
    for (const auto& [key, contact] : contacts_)
      close_gap(contact);
  }

  Forces forces;

private:
  // What the mean gradient adds, the pressure taken as zero where the sphere's own box has its middle.
  Vec3 push_of_rise(std::size_t sphere) const { return surface_.push_of_rise - rise(sphere) * surface_.area_vector; }

  double rise(std::size_t sphere) const {
    const auto& boxes = imaged_.boxes[sphere];
    return gradient_.dot(Vec3(boxes[0], boxes[1], boxes[2]).cwiseProduct(problem_.packing.box.size()));
  }

  Vec3 shear() const { return force_ - surface_.push_of_flow; }

  Vec3& shear_on(std::size_t sphere) { return forces.viscous[imaged_.original[sphere]]; }
  Vec3& on(std::size_t sphere) { return forces.sphere[imaged_.original[sphere]]; }
  Vec3& on(pfv::Face face) { return forces.wall[static_cast<std::size_t>(index(face))]; }

  void add_piece(const BoxFace& label) {
    if (!std::holds_alternative<pfv::Periodic>(problem_.faces[static_cast<std::size_t>(index(label.face))]))
      on(label.face) += force_ + surface_.push_of_rise;
  }

  void add_piece(const SphereSurface& label) {
    on(label.sphere) += force_ + push_of_rise(label.sphere);
    shear_on(label.sphere) += shear();
  }

  void add_piece(const Bridge& label) {
    const Bridge bridge = in_order(label);
    const Vec3 force = force_ + push_of_rise(bridge.sphere);
    const auto* other = std::get_if<std::size_t>(&bridge.other);
    const double share = other ? 0.5 : 1;
    on(bridge.sphere) += share * force;
    shear_on(bridge.sphere) += share * shear();
    if (other) {
      on(*other) += share * force;
      shear_on(*other) += share * shear();
    }
    Contact& contact = contacts_.try_emplace(key_of(bridge), Contact{bridge}).first->second;
    contact.area += surface_.area;
    contact.pressure += surface_.integral - rise(bridge.sphere) * surface_.area;
  }

  using Key =
      std::tuple<std::size_t, std::size_t, std::array<int, 3>>; // two spheres, or a sphere and a face, and boxes

  std::array<int, 3> boxes_between(std::size_t a, std::size_t b) const {
    std::array<int, 3> between{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      between[axis] = imaged_.boxes[b][axis] - imaged_.boxes[a][axis];
    return between;
  }

  Bridge in_order(const Bridge& bridge) const {
    const auto* other = std::get_if<std::size_t>(&bridge.other);
    if (!other)
      return bridge;
    const std::size_t a = imaged_.original[bridge.sphere];
    const std::size_t b = imaged_.original[*other];
    const bool turned = b < a || (a == b && boxes_between(bridge.sphere, *other) < std::array{0, 0, 0});
    return turned ? Bridge{*other, bridge.sphere} : bridge;
  }

  Key key_of(const Bridge& bridge) const {
    const std::size_t first = imaged_.original[bridge.sphere];
    if (const auto* face = std::get_if<pfv::Face>(&bridge.other))
      return {first, imaged_.original.size() + static_cast<std::size_t>(index(*face)), {}};
    const std::size_t other = std::get<std::size_t>(bridge.other);
    return {first, imaged_.original[other], boxes_between(bridge.sphere, other)};
  }

  void close_gap(const Contact& contact) {
    const Bridge& bridge = contact.bridge;
    const double pressure = contact.pressure / contact.area;
    const double section = bridge_section(bridge, problem_.packing, bridge_radius_, imaged_.periodic);
    const Vec3 apart = section * bridge_direction(bridge, problem_.packing);
    if (const auto* face = std::get_if<pfv::Face>(&bridge.other)) {
      const auto* open = std::get_if<pfv::Pressure>(&problem_.faces[static_cast<std::size_t>(index(*face))]);
      const double in_gap = open ? open->value : pressure;
      on(bridge.sphere) -= in_gap * apart;
      on(*face) += in_gap * apart;
    } else {
      const std::size_t other = std::get<std::size_t>(bridge.other);
      on(bridge.sphere) -= pressure * apart;
      on(other) += (pressure + rise(bridge.sphere) - rise(other)) * apart;
    }
  }

  const pfv::Case& problem_;
  const meshing::ImagedPacking& imaged_;
  Vec3 gradient_;
  double bridge_radius_;
  Vec3 force_ = Vec3::Zero(); // on the piece at hand, of the flow without the mean gradient's pressure
  SurfacePressure surface_;
  std::map<Key, Contact> contacts_;
};

} // namespace

Forces fluid_forces(const Discretisation& discretisation, const StokesSystem& system, const Boundary& boundary,
                    const pfv::Case& problem, const meshing::ImagedPacking& imaged, const FlowField& flow,
                    double bridge_radius) {
  const Vec3 gradient = imposed_gradient(problem.faces);
  const pfv::Box& box = problem.packing.box;
  const std::vector<Vec3> transfer = force_transfers(discretisation, boundary, problem, flow);
  const std::vector<Vec3> residual = held_residuals(system, boundary, gradient, flow);
  const std::vector<SurfacePressure> pressure =
      surface_pressures(discretisation, flow, gradient, (box.lower + box.upper) / 2);
  Shares shares(problem, imaged, bridge_radius);
  for (std::size_t label = 0; label < boundary.labels.size(); ++label)
    shares.add(boundary.labels[label], transfer[label] - residual[label], pressure[label]);
  shares.close_gaps();
  return shares.forces;
}

} // namespace reference::stokes_fem
