#pragma once

#include "pfv/problem/vec3.hpp"

#include <span>
#include <vector>

namespace pfv {

/// a.b summed in this order everywhere. Eigen's own order depends on the vector units, and a rounding error is enough
/// to lead a packing elsewhere.
inline double dot(const Vec3& a, const Vec3& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

struct ClosePair {
  int first, second;
};

/// Every pair of spheres in the unit cube whose surfaces are at most `reach` apart, once, by cells of the largest
/// diameter and the reach.
std::vector<ClosePair> close_pairs(std::span<const Vec3> centres, std::span<const double> radii, double reach);

} // namespace pfv
