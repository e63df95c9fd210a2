#pragma once

#include "meshing/contact_bridges.hpp"
#include "pfv/problem/packing.hpp"

#include <vector>

namespace mesher {

/// A circle on a sphere: the directions at `angle` from `axis`; a point when that is zero.
struct Circle {
  pfv::Vec3 axis;
  double angle;
};

using Circles = std::vector<Circle>;

/// By sphere, where box faces, other spheres and bridges cut it, and the corners where two of these circles meet inside
/// the box.
std::vector<Circles> circles_on_spheres(const pfv::Packing& packing, const std::vector<meshing::Bridge>& bridges);

} // namespace mesher
