#pragma once

#include <span>

namespace meshing {

struct Disc {
  double y, z; // m, from the rectangle's lower corner
  double radius;
  double arc_weight; // what the exposed length of its circle counts for
};

struct DiscUnion {
  double area = 0; // m^2, of the union of the discs inside the rectangle
  double arcs =
      0; // sum over discs of arc_weight times the angle of the circle that bounds the union inside the rectangle
};

/// The union of discs inside the rectangle (0, width_y) x (0, width_z), exactly: area = 1/2 contour integral of
/// y dz - z dy over exposed arcs and covered edges.
DiscUnion disc_union(std::span<const Disc> discs, double width_y, double width_z);

} // namespace meshing
