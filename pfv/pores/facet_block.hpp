#pragma once

#include "pfv/pores/vertex.hpp"

#include <array>

namespace pfv {

/// Triangular facets between three spheres, one to a lane.
struct FacetBlock {
  static constexpr int width = 64;
  using Lane = std::array<double, width>;

  struct Corner {
    Lane x, y, z, radius; // m
  };
  std::array<Corner, 3> corners;
  std::array<std::array<Vertex, 3>, width> vertices; // which spheres these are

  std::array<Lane, 3> normal; // unit, by the order of the corners
  Lane area;                  // m^2, S
  std::array<Lane, 3> sector; // m^2, A_k: of each corner's disc, inside the facet and not in another's disc
  Lane fluid_area;            // m^2, S_f: see open_area
  Lane gap;                   // see smallest_gap
  bool overlapping = false;   // some spheres of the block overlap
  Lane crowding;              // only when they do: see is_crowded

  /// Whether three discs of a facet share a point, or two that overlap do so near one of its sides. What pairs of discs
  /// take is then not what they cover together: measure_throat says it.
  bool is_crowded(int lane) const { return overlapping && crowding[lane] > 0; }

  /// From the corners, everything else but gaps. Lanes beyond those in use must hold something finite.
  void measure();
  void measure_gaps();
};

} // namespace pfv
