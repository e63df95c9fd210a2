#include "reference/stokes_fem/forces.hpp"

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

struct AddTo {
  Forces& forces;
  const Vec3& force;

  void operator()(const BoxFace& label) const { forces.wall[static_cast<std::size_t>(index(label.face))] += force; }
  void operator()(const SphereSurface& label) const { forces.sphere[label.sphere] += force; }
  void operator()(const Bridge& label) const {
    const auto* other = std::get_if<std::size_t>(&label.other);
    forces.sphere[label.sphere] += other ? Vec3(force / 2) : force;
    if (other)
      forces.sphere[*other] += force / 2;
  }
};

} // namespace

Forces fluid_forces(const Discretisation& discretisation, const StokesSystem& system, const Boundary& boundary,
                    const pfv::FaceConditions& faces, const FlowField& flow, std::size_t spheres) {
  Forces forces{std::vector<Vec3>(spheres, Vec3::Zero()), {}};
  forces.wall.fill(Vec3::Zero());
  std::vector<Vec3> by_label = force_transfers(discretisation, boundary, faces, flow);
  const std::vector<Vec3> residual = held_residuals(system, boundary, flow);
  for (std::size_t label = 0; label < by_label.size(); ++label) {
    by_label[label] -= residual[label];
    std::visit(AddTo{forces, by_label[label]}, boundary.labels[label]);
  }
  return forces;
}

} // namespace reference::stokes_fem
