#pragma once

#include "pfv/problem/packing.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace pfv {

/// By how many box sizes something is shifted along each axis.
using Shift = std::array<std::int8_t, 3>;

inline Shift operator+(const Shift& a, const Shift& b) {
  return {static_cast<std::int8_t>(a[0] + b[0]), static_cast<std::int8_t>(a[1] + b[1]),
          static_cast<std::int8_t>(a[2] + b[2])};
}
inline Shift operator-(const Shift& a, const Shift& b) {
  return {static_cast<std::int8_t>(a[0] - b[0]), static_cast<std::int8_t>(a[1] - b[1]),
          static_cast<std::int8_t>(a[2] - b[2])};
}

/// Scalar product with a vector whose components are per box size.
inline double along(const Vec3& per_box, const Shift& shift) {
  return per_box.x() * shift[0] + per_box.y() * shift[1] + per_box.z() * shift[2];
}

/// The spheres that vertices of the triangulation stand for. They come bar by bar, so that neighbours in space are near
/// in memory; in a periodic box their images outside the box follow.
struct Sites {
  std::vector<Sphere> spheres;
  std::vector<int> number;  // of the sphere in the packing
  std::vector<Shift> shift; // of an image from its sphere; empty unless the box is periodic

  std::size_t size() const { return spheres.size(); }
};

/// The spheres of a packing bar by bar, along z in each: see Bars.
Sites sites_of(const Packing& packing);

/// Moves the sites to where the spheres of the packing are now; numbers and images stay.
void move_sites(Sites& sites, const Packing& packing);

} // namespace pfv
