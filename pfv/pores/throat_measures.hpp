#pragma once

#include "pfv/pores/ball_part.hpp"
#include "pfv/pores/facet.hpp"

namespace pfv {

/// The facet of a throat in its own plane.
struct ThroatPlane {
  Vec3 normal;                    // unit, from the pore behind to the one ahead
  double area;                    // m^2, S
  std::array<double, 3> sector{}; // m^2, A_k by vertex: the facet's part in each sphere; none on walls

  double fluid_area() const { return area - sector[0] - sector[1] - sector[2]; } // m^2, S_f
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

/// One throat at a time, whatever its vertices are: walls, and spheres cut by walls, exactly. Blocks of throats between
/// whole spheres are measured together by FacetBlock and BipyramidBlock.
ThroatPlane measure_plane(const Box& box, std::span<const Sphere> spheres, const std::array<Vertex, 3>& vertices);
ThroatMeasures measure_throat(const Box& box, std::span<const Sphere> spheres, const std::array<Vertex, 3>& vertices,
                              const Vec3& centre_behind, const Vec3& centre_ahead);

} // namespace pfv
