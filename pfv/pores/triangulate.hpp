#pragma once

#include "pfv/pores/vertex.hpp"
#include "pfv/problem/packing.hpp"

#include <array>
#include <vector>

namespace pfv {

/// Regular (weighted Delaunay) triangulation of the spheres and the six faces of the box.
struct Triangulation {
  static constexpr int outside = -1;

  std::vector<std::array<Vertex, 4>> cells;   // positively oriented: det(v1 - v0, v2 - v0, v3 - v0) > 0
  std::vector<std::array<int, 4>> neighbours; // the cell opposite each vertex, or `outside`
  std::vector<int> hidden_spheres;            // spheres without a vertex: swallowed by others
};

/// Weights are squared radii, so that cells meet where the powers |x - c|^2 - r^2 are equal. Each face of the box
/// enters as a sphere of radius 2^23 box sizes tangent to it: within 1e-7 box sizes of its limit, the plane itself,
/// which the geometry of the pores takes exactly. Cospherical points are split by CGAL's symbolic perturbation, without
/// flat cells.
Triangulation triangulate(const Packing& packing);

} // namespace pfv
