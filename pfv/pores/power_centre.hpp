#pragma once

#include "pfv/pores/vertex.hpp"
#include "pfv/problem/packing.hpp"

#include <array>
#include <span>

namespace pfv {

/// Where four vertices have equal power |x - c|^2 - r^2: on every wall among them.
struct PowerCentre {
  /// Cells whose three unit edges from one sphere (to a wall: its normal) span less are flat: their centre is lost
  /// along the normal, to round-off or to jitter of the spheres that has no other consequence.
  static constexpr double flat_below = 2e-5;

  Vec3 point;  // m; of a flat cell the one nearest to its first sphere
  double span; // of the unit edges
  Vec3 normal; // of a flat cell; along it all points would do

  bool flat() const { return span < flat_below; }
};

/// At least one of the vertices must be a sphere.
PowerCentre power_centre(const Box& box, std::span<const Sphere> spheres, const std::array<Vertex, 4>& vertices);

/// How unlike the two pores of a throat are, from 0 to 1: |W_i - W_j| / (|W_i| + |W_j|), where W is the power of a
/// pore's centre, the squared radius of the sphere around it that meets its four at right angles. Any sphere of the
/// throat says the same.
double pore_contrast(const Sphere& sphere, const Vec3& behind, const Vec3& ahead);

} // namespace pfv
