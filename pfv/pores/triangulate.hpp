#pragma once

#include "pfv/clock.hpp"
#include "pfv/pores/sites.hpp"
#include "pfv/pores/vertex.hpp"

#include <array>
#include <vector>

namespace pfv {

/// Regular (weighted Delaunay) triangulation of the spheres and the faces of the box.
struct Triangulation {
  static constexpr int outside = -1;

  Sites sites;
  std::vector<std::array<Vertex, 4>> cells;   // positively oriented: det(v1 - v0, v2 - v0, v3 - v0) > 0
  std::vector<std::array<int, 4>> neighbours; // the cell opposite each vertex, or `outside`
  std::vector<std::array<Shift, 4>> shifts;   // of that neighbour; empty unless the box is periodic
  std::vector<int> hidden_spheres;            // spheres without a vertex: swallowed by others
};

/// Weights are squared radii, so that cells meet where the powers |x - c|^2 - r^2 are equal. Each face of the box that
/// is not periodic enters as a sphere of radius 2^23 box sizes tangent to it: within 1e-7 box sizes of its limit, the
/// plane itself, which the geometry of the pores takes exactly. Cospherical points are split by CGAL's symbolic
/// perturbation, without flat cells.
///
/// In a periodic box the images within a margin are triangulated along, each cell is kept once, and the margin is
/// doubled until no image beyond it could be in conflict with a kept cell. Throws SolveError when the cells do not
/// repeat.
///
/// Cells come bar by bar, see Bars, so that neighbours in space are near in memory.
///
/// What CGAL's triangulation itself takes is stage `triangulate`.
Triangulation triangulate(const Packing& packing, const PeriodicAxes& periodic, Clock& clock);

} // namespace pfv
