#pragma once

#include "pfv/problem/packing.hpp"

#include <string>
#include <vector>

namespace studies {

/// A packing of a kind that breaks pore networks.
struct HardPacking {
  std::string name;
  pfv::Packing packing;
  bool quick = false;        // tried in quick runs too
  double most_permeable = 1; // k over the square of the length: what it must not exceed
};

/// Lattices whose Delaunay triangulation is degenerate, wide distributions of sizes, overlaps, spheres across walls,
/// hidden ones, closed voids, next to nothing in the box, and more pores on a wall than fit into an array.
std::vector<HardPacking> hard_packings();

} // namespace studies
