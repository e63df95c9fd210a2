#include "pfv/pores/throat_measures.hpp"

#include "pfv/pores/lens.hpp"
#include "pfv/pores/wall_distance.hpp"

namespace pfv {
namespace {

constexpr int next(int corner) {
  return (corner + 1) % 3;
}
constexpr int previous(int corner) {
  return (corner + 2) % 3;
}

/// The facet of a throat with what its spheres have beyond the walls.
class Throat {
public:
  Throat(const Box& box, std::span<const Sphere> spheres, const std::array<Vertex, 3>& vertices)
      : box_(box), spheres_(spheres), vertices_(vertices), facet_(make_facet(box, spheres, vertices)) {
    for (int c = 0; c < 3; ++c)
      if (!is_wall(vertices[c]))
        cuts_[c] = wall_cuts(sphere(c), box);
  }

  ThroatPlane plane() const {
    ThroatPlane plane{facet_.normal, facet_.area};
    for (int c = 0; c < 3; ++c) {
      if (is_wall(vertices_[c]))
        continue;
      plane.sector[c] +=
          disc_in_wedge(sphere(c).radius, cuts_[c], facet_.corners[c].to_next, facet_.corners[c].to_previous);
      if (is_wall(vertices_[next(c)]))
        continue;
      const auto [radius, other, apart, distance] = pair(c);
      plane.sector[c] -= lens::half_segment(radius, distance);
      plane.sector[next(c)] -= lens::half_segment(other, apart - distance);
      if (!is_wall(vertices_[previous(c)]))
        plane.sector[c] -= reach_across(c);
    }
    return plane;
  }

  void add_pyramid(double sign, const Vec3& apex, Pyramid& pyramid, ThroatMeasures& throat) const {
    const double height = sign * (apex - facet_.point).dot(facet_.normal);
    throat.length += height;
    pyramid.volume = facet_.area * height / 3;
    pyramid.void_volume = pyramid.volume;
    const auto take = [&](int c, double volume, double surface) {
      pyramid.void_volume -= volume;
      throat.ball[c] += volume;
      throat.wetted[c] += surface;
    };
    for (int c = 0; c < 3; ++c) {
      if (is_wall(vertices_[c])) {
        throat.wetted[c] += sign * wall_surface(c, apex);
        continue;
      }
      const auto& corner = facet_.corners[c];
      const auto part =
          ball_in_cone(sphere(c).radius, cuts_[c], corner.to_next, corner.to_previous, apex - sphere(c).centre);
      take(c, sign * part.volume, sign * part.surface);
      if (is_wall(vertices_[next(c)]))
        continue;
      const auto [radius, other, apart, distance] = pair(c);
      const double dihedral = dihedral_angle(c, sign, apex);
      const double h1 = lens::cap_height(radius, distance), h2 = lens::cap_height(other, apart - distance);
      take(c, -lens::cap_volume(radius, h1, dihedral), -lens::cap_surface(radius, h1, dihedral));
      take(next(c), -lens::cap_volume(other, h2, dihedral), -lens::cap_surface(other, h2, dihedral));
    }
  }

private:
  const Sphere& sphere(int corner) const { return spheres_[vertices_[corner]]; }

  struct Pair {
    double radius, other, apart, distance;
  };
  /// The spheres at a corner and the next.
  Pair pair(int c) const {
    const double radius = sphere(c).radius, other = sphere(next(c)).radius;
    const double apart = facet_.corners[c].to_next.norm();
    return {radius, other, apart, lens::radical_distance(apart, radius, other)};
  }

  double reach_across(int c) const {
    const Vec3 side = facet_.corners[c].to_previous - facet_.corners[c].to_next;
    const double length = side.norm();
    const double start = facet_.corners[c].to_next.dot(side) / length;
    return lens::reach_across(sphere(c).radius, 2 * facet_.area / length, start, start + length);
  }

  /// Between the facet and the apex, about the line from a corner to the next; positive when the apex is on its side.
  double dihedral_angle(int c, double sign, const Vec3& apex) const {
    const Vec3 along = facet_.corners[c].to_next.normalized();
    const Vec3 inward = facet_.normal.cross(along);
    const Vec3 to_apex = apex - sphere(c).centre;
    return lanes::atan2(sign * to_apex.dot(facet_.normal), to_apex.dot(inward));
  }

  /// Area of the triangle that a pyramid has on the wall at a corner, less the discs in which that wall cuts the
  /// spheres; positive when the apex is ahead.
  double wall_surface(int c, const Vec3& apex) const {
    const Face face = face_of(vertices_[c]);
    const Vec3 outward = outward_normal(face);
    const std::array<Vec3, 2> feet{foot(next(c), face), foot(previous(c), face)};
    const double twice = (feet[1] - feet[0]).cross(apex - feet[0]).dot(outward);
    double area = 0.5 * std::abs(twice);
    for (int f = 0; f < 2; ++f) {
      const Vertex v = vertices_[f == 0 ? next(c) : previous(c)];
      if (is_wall(v))
        continue;
      const double distance = wall_distance(box_, face, spheres_[v].centre), radius = spheres_[v].radius;
      if (distance >= radius)
        continue;
      const Vec3 along = feet[1 - f] - feet[f], to_apex = apex - feet[f];
      const double angle = std::atan2(along.cross(to_apex).norm(), along.dot(to_apex));
      area -= 0.5 * (radius - distance) * (radius + distance) * angle;
    }
    return (apex - facet_.point).dot(facet_.normal) < 0 ? -area : area;
  }

  /// Where a corner of the facet meets a wall: the foot of a sphere, or of the one sphere on another wall.
  Vec3 foot(int c, Face face) const {
    const auto on = [&](Vec3 point, Face wall) -> Vec3 {
      return point + wall_distance(box_, wall, point) * outward_normal(wall);
    };
    const Vec3 point = on(is_wall(vertices_[c]) ? facet_.point : sphere(c).centre, face);
    return is_wall(vertices_[c]) ? on(point, face_of(vertices_[c])) : point;
  }

  const Box& box_;
  std::span<const Sphere> spheres_;
  const std::array<Vertex, 3>& vertices_;
  Facet facet_;
  std::array<WallCuts, 3> cuts_;
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
