#include "reference/stokes_fem/quadratic_cell.hpp"

#include <Eigen/LU>

namespace reference::stokes_fem {

namespace {

using pfv::Vec3;

Weights from_last_three(const Vec3& last) {
  return {1 - last.sum(), last[0], last[1], last[2]};
}

// Derivatives of the position by the last three weights, the first making up for them.
Eigen::Matrix3d derivative(const QuadraticCell& cell, const Weights& weights) {
  Eigen::Matrix<double, 3, 4> by_weight;
  for (int corner = 0; corner < 4; ++corner)
    by_weight.col(corner) = (4 * weights[corner] - 1) * cell.points[static_cast<std::size_t>(corner)];
  for (std::size_t edge = 0; edge < 6; ++edge) {
    const auto [a, b] = QuadraticCell::edges[edge];
    by_weight.col(a) += 4 * weights[b] * cell.points[4 + edge];
    by_weight.col(b) += 4 * weights[a] * cell.points[4 + edge];
  }
  return by_weight.rightCols<3>().colwise() - by_weight.col(0);
}

} // namespace

Eigen::Matrix<double, 10, 1> QuadraticCell::shape(const Weights& weights) {
  Eigen::Matrix<double, 10, 1> values;
  for (int corner = 0; corner < 4; ++corner)
    values[corner] = weights[corner] * (2 * weights[corner] - 1);
  for (int edge = 0; edge < 6; ++edge)
    values[4 + edge] = 4 * weights[edges[static_cast<std::size_t>(edge)].first] *
                       weights[edges[static_cast<std::size_t>(edge)].second];
  return values;
}

Weights QuadraticCell::node(int index) {
  if (index < 4)
    return Weights::Unit(index);
  const auto [a, b] = edges[static_cast<std::size_t>(index - 4)];
  return (Weights::Unit(a) + Weights::Unit(b)) / 2;
}

Vec3 QuadraticCell::at(const Weights& weights) const {
  const auto values = shape(weights);
  Vec3 point = Vec3::Zero();
  for (int node = 0; node < 10; ++node)
    point += values[node] * points[static_cast<std::size_t>(node)];
  return point;
}

Weights QuadraticCell::straight_weights(const Vec3& point) const {
  Eigen::Matrix3d sides;
  for (int side = 0; side < 3; ++side)
    sides.col(side) = points[static_cast<std::size_t>(side + 1)] - points[0];
  return from_last_three(sides.inverse() * (point - points[0]));
}

std::optional<Weights> QuadraticCell::weights_of(const Vec3& point, const Weights& start) const {
  Weights weights = start;
  for (int step = 0; step < 20; ++step) {
    const Vec3 change = derivative(*this, weights).inverse() * (point - at(weights));
    weights += Weights(-change.sum(), change[0], change[1], change[2]);
    if (!(weights.cwiseAbs().maxCoeff() < 3))
      return std::nullopt;
    if (change.cwiseAbs().maxCoeff() < 1e-11)
      return weights;
  }
  return std::nullopt;
}

std::pair<Vec3, Vec3> QuadraticCell::bounds() const {
  // The corners and the control points of the edges: the cell lies in their convex hull (Bernstein form).
  Vec3 lower = points[0];
  Vec3 upper = points[0];
  const auto add = [&](const Vec3& point) {
    lower = lower.cwiseMin(point);
    upper = upper.cwiseMax(point);
  };
  for (std::size_t corner = 1; corner < 4; ++corner)
    add(points[corner]);
  for (std::size_t edge = 0; edge < 6; ++edge)
    add(2 * points[4 + edge] -
        (points[static_cast<std::size_t>(edges[edge].first)] + points[static_cast<std::size_t>(edges[edge].second)]) /
            2);
  return {lower, upper};
}

} // namespace reference::stokes_fem
