#pragma once

#include "pfv/problem/face.hpp"

#include <array>
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

/// The facet opposite vertex f of a positively oriented cell, in the order whose normal points out of the cell.
constexpr std::array<Vertex, 3> facet_opposite(const std::array<Vertex, 4>& cell, int f) {
  constexpr int order[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  return {cell[order[f][0]], cell[order[f][1]], cell[order[f][2]]};
}

} // namespace pfv
