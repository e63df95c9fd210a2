#include "reference/openfoam/linear_flow.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

namespace reference::openfoam {

namespace {

// What is known of the flow on a boundary face.
struct OnBoundary {
  std::optional<double> pressure;
  enum class Velocity { none, no_slip, slip } velocity = Velocity::none;
};

std::vector<OnBoundary> on_boundaries(const FoamMesh& mesh, const pfv::Case& problem) {
  const Units units = units_of(problem);
  std::vector<OnBoundary> known(mesh.faces() - mesh.neighbour.size());
  for (const MeshPatch& patch : mesh.patches) {
    OnBoundary here;
    if (const auto* face = std::get_if<pfv::Face>(&patch.part)) {
      if (const auto* open = std::get_if<pfv::Pressure>(&problem.faces[static_cast<std::size_t>(pfv::index(*face))]))
        here.pressure = (open->value - units.lower_pressure) / units.pressure;
      else
        here.velocity = OnBoundary::Velocity::slip;
    } else {
      here.velocity = OnBoundary::Velocity::no_slip;
    }
    for (std::size_t face = patch.first; face < patch.first + patch.faces; ++face)
      known[face - mesh.neighbour.size()] = here;
  }
  return known;
}

// Sums of a weighted least-squares fit of a linear function.
template <int Components>
struct Fit {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 3, Components> right = Eigen::Matrix<double, 3, Components>::Zero();

  void add(const pfv::Vec3& step, const Eigen::Matrix<double, 1, Components>& difference) {
    const double weight = 1 / step.squaredNorm();
    matrix += weight * step * step.transpose();
    right += weight * step * difference;
  }
  // Too few neighbours in one direction: no slope there.
  Eigen::Matrix<double, 3, Components> slope() const {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> parts(matrix);
    Eigen::Matrix<double, 3, Components> sum = Eigen::Matrix<double, 3, Components>::Zero();
    for (int k = 0; k < 3; ++k)
      if (parts.eigenvalues()[k] > 0.03 * parts.eigenvalues()[2]) {
        const pfv::Vec3 direction = parts.eigenvectors().col(k);
        sum += direction * (direction.transpose() * right) / parts.eigenvalues()[k];
      }
    return sum;
  }
};

} // namespace

LinearFlow::LinearFlow(const FoamMesh& mesh, const CellSearch& search, const FlowFields& fields,
                       const pfv::Case& problem)
    : mesh_(mesh), search_(search), fields_(fields) {
  const auto known = on_boundaries(mesh, problem);
  for (const OnBoundary& here : known)
    known_.push_back(here.pressure);
  slopes_.reserve(mesh.cells());
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    const pfv::Vec3& centre = mesh.cell_centres[cell];
    const pfv::Vec3& velocity = fields.velocity[cell];
    Fit<3> flow;
    for (const std::size_t face : search.faces_of(cell)) {
      if (face < mesh.neighbour.size()) {
        const std::size_t other = mesh.owner[face] == cell ? mesh.neighbour[face] : mesh.owner[face];
        const pfv::Vec3 step = mesh.cell_centres[other] - centre;
        flow.add(step, (fields.velocity[other] - velocity).transpose());
        continue;
      }
      const OnBoundary& here = known[face - mesh.neighbour.size()];
      const pfv::Vec3 step = mesh.centre(face) - centre;
      if (here.velocity == OnBoundary::Velocity::no_slip)
        flow.add(step, -velocity.transpose());
      if (here.velocity == OnBoundary::Velocity::slip) {
        const pfv::Vec3 normal = mesh.area(face).normalized();
        flow.add(step, -velocity.dot(normal) * normal.transpose());
      }
    }
    slopes_.push_back(flow.slope().transpose());
  }
}

double LinearFlow::pressure(std::size_t cell, const pfv::Vec3& point) const {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  const double scale = std::sqrt(reach_of(cell));
  const auto add = [&](const pfv::Vec3& place, double value) {
    Eigen::Vector4d term;
    term << 1, (place - point) / scale;
    const double weight = 1 / (0.25 + term.tail<3>().squaredNorm());
    matrix += weight * term * term.transpose();
    right += weight * value * term;
  };
  std::vector<std::size_t> near = neighbours(cell);
  const std::size_t first = near.size();
  for (std::size_t k = 0; k < first; ++k)
    for (const std::size_t next : neighbours(near[k]))
      near.push_back(next);
  near.push_back(cell);
  std::ranges::sort(near);
  near.erase(std::unique(near.begin(), near.end()), near.end());
  for (const std::size_t one : near) {
    add(mesh_.cell_centres[one], fields_.pressure[one]);
    for (const std::size_t face : search_.faces_of(one))
      if (face >= mesh_.neighbour.size() && known_[face - mesh_.neighbour.size()])
        add(mesh_.centre(face), *known_[face - mesh_.neighbour.size()]);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> parts(matrix);
  if (parts.eigenvalues()[0] < 1e-3 * parts.eigenvalues()[3]) // in a corner of few cells
    return fields_.pressure[cell];
  return (parts.eigenvectors() * (parts.eigenvectors().transpose() * right).cwiseQuotient(parts.eigenvalues()))[0];
}

std::vector<std::size_t> LinearFlow::neighbours(std::size_t cell) const {
  std::vector<std::size_t> found;
  for (const std::size_t face : search_.faces_of(cell))
    if (face < mesh_.neighbour.size())
      found.push_back(mesh_.owner[face] == cell ? mesh_.neighbour[face] : mesh_.owner[face]);
  return found;
}

double LinearFlow::reach_of(std::size_t cell) const {
  double largest = 0;
  for (const std::size_t next : neighbours(cell))
    largest = std::max(largest, (mesh_.cell_centres[next] - mesh_.cell_centres[cell]).squaredNorm());
  return largest;
}

pfv::Vec3 LinearFlow::velocity(std::size_t cell, const pfv::Vec3& point) const {
  return fields_.velocity[cell] + slopes_[cell] * (point - mesh_.cell_centres[cell]);
}

} // namespace reference::openfoam
