#include "reference/stokes_fem/forces.hpp"

#include "reference/stokes_fem/bridge_gaps.hpp"

namespace reference::stokes_fem {

namespace {

using pfv::Vec3;

std::vector<Vec3> held_residuals(const StokesSystem& system, const Boundary& boundary, const FlowField& flow) {
  std::vector<Vec3> sum(boundary.labels.size(), Vec3::Zero());
  for (std::size_t c = 0; c < 3; ++c) {
    Eigen::VectorXd residual = system.laplacian.selfadjointView<Eigen::Lower>() * flow.velocity[c];
    residual -= system.divergence[c].transpose() * flow.pressure;
    for (std::size_t node = 0; node < boundary.holder[c].size(); ++node)
      if (const int holder = boundary.holder[c][node]; holder != Boundary::free)
        sum[static_cast<std::size_t>(holder)][static_cast<int>(c)] += residual[static_cast<Eigen::Index>(node)];
  }
  return sum;
}

// Adds the force on a piece of boundary to whom it belongs.
struct AddTo {
  Forces& forces;
  const pfv::Case& problem;
  double bridge_radius;
  Vec3 force;
  double pressure; // mean over the piece

  Vec3& on(pfv::Face face) const { return forces.wall[static_cast<std::size_t>(index(face))]; }

  void operator()(const BoxFace& label) const { on(label.face) += force; }

  void operator()(const SphereSurface& label) const { forces.sphere[label.sphere] += force; }

  void operator()(const Bridge& label) const {
    const double section = bridge_section(label, problem.packing, bridge_radius);
    const Vec3 apart = section * bridge_direction(label, problem.packing);
    if (const auto* face = std::get_if<pfv::Face>(&label.other)) {
      const auto* open = std::get_if<pfv::Pressure>(&problem.faces[static_cast<std::size_t>(index(*face))]);
      const double in_gap = open ? open->value : pressure;
      forces.sphere[label.sphere] += force - in_gap * apart;
      on(*face) += in_gap * apart;
    } else {
      forces.sphere[label.sphere] += force / 2 - pressure * apart;
      forces.sphere[std::get<std::size_t>(label.other)] += force / 2 + pressure * apart;
    }
  }
};

} // namespace

Forces fluid_forces(const Discretisation& discretisation, const StokesSystem& system, const Boundary& boundary,
                    const pfv::Case& problem, const FlowField& flow, double bridge_radius) {
  Forces forces{std::vector<Vec3>(problem.packing.spheres.size(), Vec3::Zero()), {}};
  forces.wall.fill(Vec3::Zero());
  const std::vector<Vec3> transfer = force_transfers(discretisation, boundary, problem.faces, flow);
  const std::vector<Vec3> residual = held_residuals(system, boundary, flow);
  const std::vector<double> pressure = mean_pressures(discretisation, flow);
  for (std::size_t label = 0; label < boundary.labels.size(); ++label)
    std::visit(AddTo{forces, problem, bridge_radius, transfer[label] - residual[label], pressure[label]},
               boundary.labels[label]);
  return forces;
}

} // namespace reference::stokes_fem
