#pragma once

#include "pfv/problem/face.hpp"
#include "pfv/problem/vec3.hpp"

#include <cmath>
#include <span>
#include <vector>

namespace pfv {

/// a.b summed in this order everywhere. Eigen's own order depends on the vector units, and a rounding error is enough
/// to lead a packing elsewhere.
inline double dot(const Vec3& a, const Vec3& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

/// A difference of two places, or where an axis is periodic that to the nearest image, in boxes of side `size`.
inline Vec3 nearest_image(const Vec3& difference, const PeriodicAxes& periodic, double size = 1) {
  Vec3 nearest = difference;
  for (int axis = 0; axis < 3; ++axis)
    if (periodic[axis])
      nearest[axis] -= size * std::round(nearest[axis] / size);
  return nearest;
}

struct ClosePair {
  int first, second;
};

/// Every pair of spheres in the unit cube whose surfaces, or those of their nearest images, are at most `reach` apart,
/// once, by cells of the largest diameter and the reach. Along a periodic axis centres may lie outside of the cube.
std::vector<ClosePair> close_pairs(std::span<const Vec3> centres, std::span<const double> radii, double reach,
                                   const PeriodicAxes& periodic = {});

} // namespace pfv
