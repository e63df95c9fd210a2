#pragma once

#include "pfv/problem/face.hpp"

#include <cstdint>

namespace pfv {

/// A vertex of the triangulation: a sphere by its index in the packing, or a face of the box, which is a sphere of
/// infinite radius and has a negative number.
using Vertex = std::int32_t;

constexpr bool is_wall(Vertex vertex) {
  return vertex < 0;
}
constexpr Vertex wall_vertex(Face face) {
  return -1 - index(face);
}
constexpr Face face_of(Vertex wall) {
  return static_cast<Face>(-1 - wall);
}

} // namespace pfv
