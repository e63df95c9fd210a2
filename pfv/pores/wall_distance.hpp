#pragma once

#include "pfv/problem/face.hpp"
#include "pfv/problem/packing.hpp"

namespace pfv {

/// Distance (m) of a point from the plane of a face of the box, positive inside.
inline double wall_distance(const Box& box, Face face, const Vec3& point) {
  const int axis = index(axis_of(face));
  return is_upper(face) ? box.upper[axis] - point[axis] : point[axis] - box.lower[axis];
}

} // namespace pfv
