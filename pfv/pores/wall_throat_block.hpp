#pragma once

#include "pfv/pores/bipyramid_block.hpp"

namespace pfv {

/// Throats between two spheres and a wall, one to a lane. The facet is the trapezoid between the centres and their feet
/// on the wall; the pores behind and ahead have their centres on the wall too. Everything is signed as in
/// BipyramidBlock.
struct WallThroatBlock {
  static constexpr int width = FacetBlock::width;
  using Lane = FacetBlock::Lane;

  std::array<FacetBlock::Corner, 2> corners;         // spheres; the wall comes third
  std::array<Lane, 2> distance;                      // m, of their centres from the wall
  std::array<Lane, 3> outward;                       // unit, of the wall
  std::array<int, width> wall;                       // which of the throat's vertices is the wall
  std::array<std::array<Vertex, 3>, width> vertices; // of the throat, in its own order
  BipyramidBlock::Side behind, ahead;

  std::array<Lane, 3> normal; // unit, from behind to ahead
  Lane area;                  // m^2, S
  std::array<Lane, 2> sector; // m^2, A_k
  Lane fluid_area;            // m^2, S_f
  Lane crowding;              // see is_crowded

  Lane length;                // m, l
  std::array<Lane, 3> wetted; // m^2, gamma: of the spheres and of the wall
  std::array<Lane, 2> ball;   // m^3

  /// Whether the spheres overlap or the wall cuts one: measure_throat says what is left of them.
  bool is_crowded(int lane) const { return crowding[lane] > 0; }

  /// What belongs to the spheres and the wall of a lane, in the order of the throat's vertices.
  std::array<double, 3> by_vertex(const std::array<double, 3>& values, int lane) const {
    const int first = (2 - wall[lane]) % 3;
    return {values[first], values[(first + 1) % 3], values[(first + 2) % 3]};
  }

  /// From the spheres and the wall. Lanes beyond those in use must hold something finite.
  void measure_facets();
  /// From measured facets and the centres.
  void measure_bipyramids();
};

} // namespace pfv
