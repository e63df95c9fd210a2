#include "pfv/pores/facet_section.hpp"

#include "pfv/pores/lens.hpp"
#include "pfv/pores/short_list.hpp"
#include "pfv/pores/wall_distance.hpp"

#include <algorithm>

namespace pfv {
namespace {

using Vec2 = Eigen::Vector2d;
using Polygon = ShortList<Vec2, 8>; // a facet has five corners at most, and each of two lines adds one

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The part of a convex polygon where point . along <= distance.
Polygon clipped(const Polygon& polygon, const Vec2& along, double distance) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double da = a.dot(along) - distance, db = b.dot(along) - distance;
    if (da <= 0)
      kept.push_back(a);
    if ((da < 0 && db > 0) || (da > 0 && db < 0))
      kept.push_back(a + da / (da - db) * (b - a));
  }
  return kept;
}

/// Area of a disc about the origin in the triangle between the origin, a and b: inside of the disc it ends on a b,
/// outside on the circle. Negative when the origin is on the right of a b.
double disc_in_triangle(double radius, const Vec2& a, const Vec2& b) {
  const double twice = cross(a, b);
  if (twice == 0)
    return 0;
  const Vec2 side = b - a;
  const double length = side.norm(), off = std::abs(twice) / length;
  if (off >= radius)
    return 0.5 * radius * radius * lanes::atan2(twice, a.dot(b));
  const double from = a.dot(side) / length, to = b.dot(side) / length;
  const double chord = std::sqrt((radius - off) * (radius + off));
  const double low = std::clamp(from, -chord, chord), high = std::clamp(to, -chord, chord);
  const auto turn = [&](double one, double other) { // zero where nothing is on the circle
    return one == other ? 0 : lanes::atan2(other, off) - lanes::atan2(one, off);
  };
  const double area = 0.5 * (off * (high - low) + radius * radius * (turn(from, low) + turn(high, to)));
  return twice < 0 ? -area : area;
}

double disc_in(const Polygon& polygon, double radius) {
  double area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    area += disc_in_triangle(radius, polygon[i], polygon[(i + 1) % polygon.size()]);
  return area;
}

/// A facet in the coordinates of its plane.
class Section {
public:
  Section(const Box& box, std::span<const Sphere> spheres, const Facet& facet)
      : box_(box), spheres_(spheres), facet_(facet) {
    const Vec3 u = facet.corners[0].to_next.normalized(), v = facet.normal.cross(u);
    const auto in_plane = [&](const Vec3& vector) { return Vec2(vector.dot(u), vector.dot(v)); };
    for (int c = 0; c < 3; ++c)
      at_[c] = in_plane(is_wall(vertex(c)) ? outward_normal(face_of(vertex(c))) : sphere(c).centre - facet.point);
  }

  /// As seen from the sphere at a corner, which is the origin.
  Polygon outline(int corner) const {
    Polygon polygon;
    for (int c = 0; c < 3; ++c)
      if (!is_wall(vertex(c))) {
        polygon.push_back(at_[c] - at_[corner]);
      } else {
        polygon.push_back(foot((c + 2) % 3, c) - at_[corner]);
        polygon.push_back(foot((c + 1) % 3, c) - at_[corner]);
      }
    return polygon;
  }

  double covered_by(int corner) const {
    Polygon own_side = outline(corner);
    const double radius = sphere(corner).radius;
    for (const int other : {(corner + 1) % 3, (corner + 2) % 3}) {
      if (is_wall(vertex(other)))
        continue;
      const Vec2 along = at_[other] - at_[corner];
      const double apart = along.norm();
      const double distance = lens::radical_distance(apart, radius, sphere(other).radius);
      if (distance < radius)
        own_side = clipped(own_side, along / apart, distance);
    }
    return disc_in(own_side, radius);
  }

private:
  Vertex vertex(int corner) const { return facet_.corners[corner].vertex; }
  const Sphere& sphere(int corner) const { return spheres_[vertex(corner)]; }

  /// Of a corner on a wall at another: where it is a wall too, of the facet's only sphere on both.
  Vec2 foot(int corner, int wall) const {
    const int only = 3 - corner - wall;
    const int from = is_wall(vertex(corner)) ? only : corner;
    const auto to_wall = [&](int w) -> Vec2 {
      return wall_distance(box_, face_of(vertex(w)), sphere(from).centre) * at_[w];
    };
    const Vec2 point = at_[from] + to_wall(wall);
    return from == corner ? point : point + to_wall(corner);
  }

  const Box& box_;
  std::span<const Sphere> spheres_;
  const Facet& facet_;
  std::array<Vec2, 3> at_; // spheres, and outward directions of walls
};

} // namespace

std::array<double, 3> covered_parts(const Box& box, std::span<const Sphere> spheres, const Facet& facet) {
  const Section section(box, spheres, facet);
  std::array<double, 3> part{};
  for (int c = 0; c < 3; ++c)
    if (!is_wall(facet.corners[c].vertex))
      part[c] = section.covered_by(c);
  return part;
}

} // namespace pfv
