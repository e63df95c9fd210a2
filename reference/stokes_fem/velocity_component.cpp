#include "reference/stokes_fem/velocity_component.hpp"

#include <algorithm>

namespace reference::stokes_fem {

namespace {

SparseRows restrict_columns(const SparseRows& full, const VelocityComponent& component) {
  SparseRows part(full.rows(), component.size);
  part.reserve(full.nonZeros());
  for (Eigen::Index row = 0; row < full.outerSize(); ++row) {
    part.startVec(row);
    for (SparseRows::InnerIterator it(full, row); it; ++it)
      if (const int column = component.free_index[static_cast<std::size_t>(it.col())]; column >= 0)
        part.insertBack(row, column) = it.value();
  }
  part.finalize();
  return part;
}

VelocityComponent free_component(const StokesSystem& system, const Boundary& boundary, const pfv::FaceConditions& faces,
                                 std::size_t c) {
  VelocityComponent component;
  for (const int holder : boundary.holder[c])
    component.free_index.push_back(holder == Boundary::free ? static_cast<int>(component.size++) : -1);
  component.divergence = restrict_columns(system.divergence[c], component);
  component.load = Eigen::VectorXd::Zero(component.size);
  component.load -= imposed_gradient(faces)[static_cast<int>(c)] * component.gather(system.node_volume);
  const auto axis = static_cast<pfv::Axis>(c);
  for (const pfv::Face face : {pfv::lower_face(axis), pfv::upper_face(axis)}) {
    const auto f = static_cast<std::size_t>(index(face));
    if (const auto* pressure = std::get_if<pfv::Pressure>(&faces[f]))
      component.load -= (is_upper(face) ? 1 : -1) * pressure->value * component.gather(boundary.face_weight[f]);
  }
  return component;
}

} // namespace

Eigen::VectorXd VelocityComponent::gather(const Eigen::VectorXd& nodal) const {
  Eigen::VectorXd values(size);
  for (std::size_t node = 0; node < free_index.size(); ++node)
    if (free_index[node] >= 0)
      values[free_index[node]] = nodal[static_cast<Eigen::Index>(node)];
  return values;
}

Eigen::VectorXd VelocityComponent::scatter(const Eigen::VectorXd& values) const {
  Eigen::VectorXd nodal = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(free_index.size()));
  for (std::size_t node = 0; node < free_index.size(); ++node)
    if (free_index[node] >= 0)
      nodal[static_cast<Eigen::Index>(node)] = values[free_index[node]];
  return nodal;
}

VelocityComponents free_components(const StokesSystem& system, const Boundary& boundary,
                                   const pfv::FaceConditions& faces) {
  VelocityComponents components{free_component(system, boundary, faces, 0), free_component(system, boundary, faces, 1),
                                free_component(system, boundary, faces, 2)};
  const bool has_level =
      std::ranges::any_of(faces, [](const auto& face) { return std::holds_alternative<pfv::Pressure>(face); });
  if (!has_level) // one pressure stays at zero; its equation is the sum of all others
    for (VelocityComponent& component : components)
      for (SparseRows::InnerIterator it(component.divergence, 0); it; ++it)
        it.valueRef() = 0;
  return components;
}

} // namespace reference::stokes_fem
