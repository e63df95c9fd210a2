#pragma once

#include "pfv/pores/short_list.hpp"
#include "pfv/problem/packing.hpp"

#include <span>

namespace pfv {

/// A wall that cuts a sphere: outward unit normal and distance from the sphere's centre, 0 <= distance < radius (m).
struct WallCut {
  Vec3 outward;
  double distance;
};

using WallCuts = ShortList<WallCut, 6>;

/// The walls of the box that cut a sphere; none for a sphere wholly inside or just touching.
WallCuts wall_cuts(const Sphere& sphere, const Box& box);

/// Area (m^2) of the part of a disc of that radius in the plane of two directions and between them, inside the box.
double disc_in_wedge(double radius, std::span<const WallCut> cuts, const Vec3& a, const Vec3& b);

} // namespace pfv
