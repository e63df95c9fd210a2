#pragma once

#include "pfv/problem/vec3.hpp"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <utility>

namespace reference::stokes_fem {

/// Barycentric coordinates in a tetrahedron; in a curved one, of the straight one it is the image of.
using Weights = Eigen::Vector4d;

/// Tetrahedron bent by the middles of its edges: its points are the image of the straight one under the quadratic map
/// through four corners and six middles, numbered as the elements number their nodes.
struct QuadraticCell {
  static constexpr std::array<std::pair<int, int>, 6> edges{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

  std::array<pfv::Vec3, 10> points;

  /// Values of the ten quadratic shape functions.
  static Eigen::Matrix<double, 10, 1> shape(const Weights& weights);
  /// The weights of node 0 ... 9.
  static Weights node(int index);

  pfv::Vec3 at(const Weights& weights) const;
  /// As if its edges were straight.
  Weights straight_weights(const pfv::Vec3& point) const;
  /// Where `at` gives the point, by Newton steps from `start`; nothing when they do not settle near the cell.
  std::optional<Weights> weights_of(const pfv::Vec3& point, const Weights& start) const;
  /// Corners of an axis-aligned box that holds the whole cell.
  std::pair<pfv::Vec3, pfv::Vec3> bounds() const;
};

} // namespace reference::stokes_fem
