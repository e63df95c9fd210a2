#pragma once

#include "pfv/problem/packing.hpp"

namespace reference::openfoam {

struct Disc {
  pfv::Vec3 centre; // m
  pfv::Vec3 normal; // of unit length
  double radius;    // m
};

/// Area in m^2 of the part of a disc that lies inside a box or on its faces: by 64 x 256 points of equal area, exact to
/// round-off when faces halve or quarter it.
double area_inside(const Disc& disc, const pfv::Box& box);

} // namespace reference::openfoam
