#pragma once

#include "pfv/pores/vertex.hpp"
#include "pfv/problem/packing.hpp"

#include <array>
#include <span>

namespace pfv {

/// Corner c of a facet: where it is and the directions to the two other corners, in the facet's order. A wall corner is
/// no point but the wall's outward direction.
struct FacetCorner {
  Vertex vertex;
  Vec3 to_next;
  Vec3 to_previous;
};

/// Side of a pore between three vertices: a triangle, a trapezoid that ends on a wall (two spheres and a wall) or a
/// rectangle that ends on two (one sphere and two walls).
struct Facet {
  std::array<FacetCorner, 3> corners;
  Vec3 point;  // m, the centre of one of its spheres
  Vec3 normal; // unit, by the order of the vertices; zero when the vertices are in line
  double area; // m^2
};

/// The facet of these vertices, at least one of them a sphere.
Facet make_facet(const Box& box, std::span<const Sphere> spheres, const std::array<Vertex, 3>& vertices);

/// The smallest gap between two of these spheres over the distance of their centres, and between one and a wall over
/// the distance of its centre from the wall, as between it and its mirror image. From 0, where two touch or overlap,
/// to 1, which is also that of a sphere centred on the wall: it has no image but itself.
double smallest_gap(const Box& box, std::span<const Sphere> spheres, const std::array<Vertex, 3>& vertices);

} // namespace pfv
