#pragma once

#include "pfv/pores/facet.hpp"

namespace pfv {

/// The facet of a throat in its own plane.
struct ThroatPlane {
  Vec3 normal;                    // unit, from the pore behind to the one ahead
  double area;                    // m^2, S
  std::array<double, 3> sector{}; // m^2, A_k by vertex: see covered_parts
  double fluid_area = 0;          // m^2, S_f: see open_area
};

/// The pyramid between a facet and the centre of one of its pores, negative when the centre is on the wrong side.
struct Pyramid {
  double volume = 0;      // m^3
  double void_volume = 0; // m^3
};

/// A throat with its bipyramid.
struct ThroatMeasures {
  ThroatPlane plane;
  double length = 0; // m, l
  Pyramid behind, ahead;
  std::array<double, 3> wetted{}; // m^2, gamma by vertex; of a wall its area between the spheres
  std::array<double, 3> ball{};   // m^3, of the sphere at each vertex
};

/// One throat at a time, exactly, whatever its vertices are: walls, spheres cut by walls, and any number of spheres
/// that share a point. Throats between spheres are measured in blocks by FacetBlock and BipyramidBlock, but for crowded
/// ones.
ThroatPlane measure_plane(const Box& box, std::span<const Sphere> spheres, const std::array<Vertex, 3>& vertices);
ThroatMeasures measure_throat(const Box& box, std::span<const Sphere> spheres, const std::array<Vertex, 3>& vertices,
                              const Vec3& centre_behind, const Vec3& centre_ahead);

} // namespace pfv
