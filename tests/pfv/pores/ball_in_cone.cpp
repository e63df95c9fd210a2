#include "ball_in_cone.hpp"

#include "solid_angle.hpp"

#include <cmath>

namespace pfv::testing {
namespace {

// Directions of any length, anticlockwise seen from outside; each of at most 12 clips adds one to a triangle.
using Polygon = ShortList<Vec3, 16>;

/// The part of a convex spherical polygon where normal . direction >= 0.
Polygon clipped(const Polygon& polygon, const Vec3& normal) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3& a = polygon[i];
    const Vec3& b = polygon[(i + 1) % polygon.size()];
    const double da = normal.dot(a), db = normal.dot(b);
    if (da >= 0)
      kept.push_back(a);
    if ((da > 0 && db < 0) || (da < 0 && db > 0))
      kept.push_back(std::abs(db) * a + std::abs(da) * b);
  }
  return kept.size() < 3 ? Polygon{} : kept;
}

double polygon_solid_angle(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    sum += solid_angle(polygon[0], polygon[i - 1], polygon[i]);
  return sum;
}

/// What a wall cuts off: the solid angle of the directions that meet the wall first and the area of wall they cover.
struct CutOff {
  double angle = 0; // sr
  double area = 0;  // m^2
};

/// The cut-off in the cone of the wall's normal and one edge a -> b of a polygon in front of the wall: a circular
/// sector where the edge runs outside the circle in which wall and sphere meet, a triangle where it runs inside.
CutOff cut_off_under_edge(double radius, const WallCut& cut, const Vec3& a, const Vec3& b) {
  const double cosine = cut.distance / radius;
  const double circle = std::sqrt(std::max(0.0, radius * radius - cut.distance * cut.distance));
  const auto along = [&](double t) -> Vec3 { return (1 - t) * a + t * b; };
  const auto across = [&](const Vec3& d) -> Vec3 { return d - cut.outward.dot(d) * cut.outward; };
  // Where the direction meets the wall, from the foot of the normal; held on the circle against round-off.
  const auto foot = [&](const Vec3& d) -> Vec3 {
    const Vec3 off = across(d);
    const double reach = off.norm(), height = cut.outward.dot(d);
    const bool within = reach * cut.distance < circle * height;
    return within ? cut.distance / height * off : circle / reach * off;
  };

  // |across|^2 cosine^2 - along^2 (1 - cosine^2) = 0 on the circle: a quadratic in t.
  const Vec3 step = b - a;
  const auto form = [&](const Vec3& u, const Vec3& v) {
    return cosine * cosine * across(u).dot(across(v)) - (1 - cosine * cosine) * cut.outward.dot(u) * cut.outward.dot(v);
  };
  const double qa = form(step, step), qb = form(a, step), qc = form(a, a);
  ShortList<double, 4> ends{0};
  const double discriminant = qb * qb - qa * qc;
  if (discriminant > 0) {
    const double q = -(qb + std::copysign(std::sqrt(discriminant), qb));
    double t0 = q != 0 ? qc / q : -1, t1 = qa != 0 ? q / qa : -1;
    if (t0 > t1)
      std::swap(t0, t1);
    for (const double t : {t0, t1})
      if (t > 0 && t < 1)
        ends.push_back(t);
  }
  ends.push_back(1);

  CutOff sum;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const Vec3 from = along(ends[i - 1]), to = along(ends[i]), middle = along(0.5 * (ends[i - 1] + ends[i]));
    if (form(middle, middle) < 0) {
      const Vec3 p = foot(from), q = foot(to), to_wall = cut.distance * cut.outward;
      sum.angle += solid_angle(to_wall, to_wall + p, to_wall + q);
      sum.area += 0.5 * cut.outward.dot(p.cross(q));
    } else {
      const Vec3 p = across(from), q = across(to);
      const double turn = std::atan2(cut.outward.dot(p.cross(q)), p.dot(q));
      sum.angle += turn * (1 - cosine);
      sum.area += 0.5 * circle * circle * turn;
    }
  }
  return sum;
}

} // namespace

BallPart ball_in_cone(double radius, std::span<const WallCut> cuts, const Vec3& a, const Vec3& b, const Vec3& c) {
  const double r2 = radius * radius;
  if (cuts.empty()) {
    const double angle = solid_angle(a, b, c);
    return {r2 * radius * angle / 3, r2 * angle};
  }
  const double orientation = a.dot(b.cross(c));
  if (orientation == 0)
    return {};
  const double sign = orientation > 0 ? 1 : -1;
  Polygon cone = sign > 0 ? Polygon{a, b, c} : Polygon{a, c, b};
  for (const auto& cut : cuts)
    if (cut.distance == 0)
      cone = clipped(cone, -cut.outward);

  double angle = polygon_solid_angle(cone);
  double flat_volume = 0;
  for (const auto& cut : cuts) {
    if (cut.distance == 0)
      continue;
    Polygon front = clipped(cone, cut.outward);
    for (const auto& other : cuts) // where two walls cut, each takes the directions that meet it first
      if (&other != &cut && other.distance > 0)
        front = clipped(front, other.distance * cut.outward - cut.distance * other.outward);
    for (std::size_t i = 0; i < front.size(); ++i) {
      const auto off = cut_off_under_edge(radius, cut, front[i], front[(i + 1) % front.size()]);
      angle -= off.angle;
      flat_volume += cut.distance * off.area / 3;
    }
  }
  return {sign * (r2 * radius * angle / 3 + flat_volume), sign * r2 * angle};
}

} // namespace pfv::testing
