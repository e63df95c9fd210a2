#include "pfv/pores/disc_part.hpp"

#include "pfv/pores/wall_distance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pfv {
namespace {

constexpr double on_wall = 1e-12; // of the radius: the centre lies on the wall

/// A wall's trace in the plane of the disc: the line m cos(phi - towards) rho = distance.
struct Trace {
  double distance;
  double towards;
  double steepness;

  double range(double phi) const { // rho at which direction phi meets the wall; huge when it does not
    const double approach = steepness * std::cos(phi - towards);
    return approach > 0 ? distance / approach : HUGE_VAL;
  }
};

// Two ends and, for each of 6 traces, 3 turns of 2 crossings with the circle and of 2 with each other trace.
using Breaks = ShortList<double, 2 + 6 * 6 + 15 * 6>;

/// Angles at which the nearest bound (circle or one of the traces) may change, inside (0, angle).
Breaks breaks(double radius, std::span<const Trace> traces, double angle) {
  Breaks result{0, angle};
  const auto add = [&](double phi) {
    for (const double turn : {-2.0, 0.0, 2.0})
      if (const double at = phi + turn * std::numbers::pi; at > 0 && at < angle)
        result.push_back(at);
  };
  for (std::size_t i = 0; i < traces.size(); ++i) {
    const auto& t = traces[i];
    if (t.distance < radius * t.steepness) {
      const double half = std::acos(t.distance / (radius * t.steepness));
      add(t.towards - half);
      add(t.towards + half);
    }
    for (std::size_t j = 0; j < i; ++j) { // where two traces cross: t.range = u.range
      const auto& u = traces[j];
      const double c = t.distance * u.steepness * std::cos(u.towards) - u.distance * t.steepness * std::cos(t.towards);
      const double s = t.distance * u.steepness * std::sin(u.towards) - u.distance * t.steepness * std::sin(t.towards);
      const double crossing = std::atan2(-c, s);
      add(crossing);
      add(crossing + std::numbers::pi);
    }
  }
  std::ranges::sort(result);
  return result;
}

} // namespace

WallCuts wall_cuts(const Sphere& sphere, const Box& box) {
  WallCuts cuts;
  for (const Face face : all_faces) {
    const double distance = wall_distance(box, face, sphere.centre);
    if (distance < sphere.radius)
      cuts.push_back({outward_normal(face), distance > on_wall * sphere.radius ? distance : 0});
  }
  return cuts;
}

double disc_in_wedge(double radius, std::span<const WallCut> cuts, const Vec3& a, const Vec3& b) {
  const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
  if (cuts.empty())
    return 0.5 * radius * radius * angle;
  const Vec3 u = a.normalized();
  const Vec3 v = (b - b.dot(u) * u).normalized();
  ShortList<Trace, 6> traces;
  for (const auto& cut : cuts) {
    const double c = cut.outward.dot(u), s = cut.outward.dot(v);
    traces.push_back({cut.distance, std::atan2(s, c), std::hypot(c, s)});
  }
  const auto at = breaks(radius, traces, angle);
  double area = 0;
  for (std::size_t i = 1; i < at.size(); ++i) {
    const double turn = at[i] - at[i - 1], middle = 0.5 * (at[i] + at[i - 1]);
    const auto nearest =
        std::ranges::min_element(traces, {}, [middle](const Trace& trace) { return trace.range(middle); });
    if (nearest->range(middle) >= radius)
      area += 0.5 * radius * radius * turn;
    else if (nearest->distance > 0)
      area += 0.5 * nearest->range(at[i - 1]) * nearest->range(at[i]) * std::sin(turn);
  }
  return area;
}

} // namespace pfv
