#pragma once

#include "pfv/problem/packing.hpp"

namespace meshing {

struct VoidMeasure {
  double volume;  // m^3, box minus union of spheres
  double surface; // m^2, of the spheres inside the box and outside each other
};

/// Volume and wetted surface of the void, spheres cut by the box and overlapping each other in any way: slices across
/// x, each an exact area and arc length (Green's theorem over the arcs), integrated along x by adaptive Gauss-Kronrod
/// between the places where a slice changes its shape. Exact to about 1e-10 of the box.
VoidMeasure exact_void(const pfv::Packing& packing);

} // namespace meshing
