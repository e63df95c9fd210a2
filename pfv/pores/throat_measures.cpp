#include "pfv/pores/throat_measures.hpp"

#include "pfv/pores/facet_section.hpp"
#include "pfv/pores/open_area.hpp"
#include "pfv/pores/orthoscheme.hpp"
#include "pfv/pores/short_list.hpp"

#include <algorithm>

namespace pfv {
namespace {

constexpr int next(int corner) {
  return (corner + 1) % 3;
}
constexpr int previous(int corner) {
  return (corner + 2) % 3;
}

/// The facet of a throat. The radical planes of its spheres, and its walls, meet in the power centre of a pore on
/// either side, whose foot on the facet is R. So the own sides of the spheres, on the way from the facet to that centre
/// P, are six orthoschemes k E R P: from each sphere k by way of the plane to each other corner, which it meets at
/// right angles in E.
class Throat {
public:
  Throat(const Box& box, std::span<const Sphere> spheres, const std::array<Vertex, 3>& vertices)
      : box_(box), spheres_(spheres), facet_(make_facet(box, spheres, vertices)) {
    for (int c = 0; c < 3; ++c)
      if (!is_wall(vertices[c]))
        for (const int other : {next(c), previous(c)}) {
          const auto& corner = facet_.corners[c];
          const Vec3 towards = (other == next(c) ? corner.to_next : corner.to_previous).normalized();
          const Vec3 turned = facet_.normal.cross(towards);
          ways_.push_back({c, other, towards, other == next(c) ? turned : -turned});
        }
  }

  ThroatPlane plane() const {
    const auto sector = covered_parts(box_, spheres_, facet_);
    double largest_radius = 0;
    for (const auto& corner : facet_.corners)
      if (!is_wall(corner.vertex))
        largest_radius = std::max(largest_radius, spheres_[corner.vertex].radius);
    return {facet_.normal, facet_.area, sector,
            open_area(facet_.area, sector[0] + sector[1] + sector[2], largest_radius)};
  }

  void add_pyramid(double sign, const Vec3& apex, Pyramid& pyramid, ThroatMeasures& throat) const {
    const double height = sign * (apex - facet_.point).dot(facet_.normal);
    throat.length += height;
    pyramid.volume = facet_.area * height / 3;
    pyramid.void_volume = pyramid.volume;
    for (const auto& [from, to, towards, inward] : ways_) {
      const auto& [centre, radius] = spheres_[facet_.corners[from].vertex];
      const Vec3 way = apex - centre;
      const double along_base = way.dot(inward);
      const auto part = ball_in_orthoscheme(radius, way.dot(towards), along_base, height);
      pyramid.void_volume -= part.volume;
      throat.ball[from] += part.volume;
      throat.wetted[from] += part.surface;
      if (is_wall(facet_.corners[to].vertex))
        throat.wetted[to] += 0.5 * along_base * height - part.base;
    }
  }

private:
  struct Way {
    int from, to;         // corners: a sphere, and another one or a wall
    Vec3 towards, inward; // unit, along k E and E R
  };

  const Box& box_;
  std::span<const Sphere> spheres_;
  Facet facet_;
  ShortList<Way, 6> ways_;
};

} // namespace

ThroatPlane measure_plane(const Box& box, std::span<const Sphere> spheres, const std::array<Vertex, 3>& vertices) {
  return Throat(box, spheres, vertices).plane();
}

ThroatMeasures measure_throat(const Box& box, std::span<const Sphere> spheres, const std::array<Vertex, 3>& vertices,
                              const Vec3& centre_behind, const Vec3& centre_ahead) {
  const Throat throat(box, spheres, vertices);
  ThroatMeasures measures;
  measures.plane = throat.plane();
  throat.add_pyramid(-1, centre_behind, measures.behind, measures);
  throat.add_pyramid(1, centre_ahead, measures.ahead, measures);
  return measures;
}

} // namespace pfv
