#include "pfv/problem/face_condition.hpp"

#include "pfv/problem/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pfv {

Axis axis_named(std::string_view name) {
  const auto found = std::ranges::find(axis_names, name);
  if (found == axis_names.end())
    throw InputError(fmt::format("axis \"{}\" must be one of {}", name, fmt::join(axis_names, ", ")));
  return static_cast<Axis>(found - axis_names.begin());
}

PeriodicAxes axes_named(std::span<const std::string> names) {
  PeriodicAxes axes{};
  for (const std::string& name : names)
    axes[index(axis_named(name))] = true;
  return axes;
}

namespace {

/// Linear between the points, constant beyond them.
template <class Point>
double between(const std::vector<Point>& points, double Point::*place, double at) {
  const auto upper = std::ranges::upper_bound(points, at, {}, place);
  if (upper == points.begin())
    return points.front().pressure;
  if (upper == points.end())
    return points.back().pressure;
  const Point &a = upper[-1], &b = upper[0];
  return a.pressure + (b.pressure - a.pressure) * ((at - a.*place) / (b.*place - a.*place));
}

} // namespace

double PressureProfile::at(double position) const {
  return between(points, &Point::position, position);
}

double PressureInTime::at(double time) const {
  return between(points, &Point::time, time);
}

PeriodicAxes periodic_axes(const FaceConditions& faces) {
  PeriodicAxes periodic{};
  for (const Axis axis : {Axis::x, Axis::y, Axis::z})
    periodic[index(axis)] = std::holds_alternative<Periodic>(faces[index(lower_face(axis))]);
  return periodic;
}

Vec3 imposed_gradient(const FaceConditions& faces) {
  Vec3 gradient = Vec3::Zero();
  for (const Axis axis : {Axis::x, Axis::y, Axis::z})
    if (const auto* periodic = std::get_if<Periodic>(&faces[index(lower_face(axis))]))
      gradient[index(axis)] = periodic->gradient;
  return gradient;
}

FaceConditions flow_along(Axis axis, double pressure_drop, Tangential tangential) {
  FaceConditions faces{};
  faces[index(lower_face(axis))] = Pressure{0, tangential};
  faces[index(upper_face(axis))] = Pressure{pressure_drop, tangential};
  return faces;
}

FaceConditions flow_along(Axis axis, double pressure_drop, const PeriodicAxes& periodic, const Box& box,
                          Tangential tangential) {
  FaceConditions faces = flow_along(axis, pressure_drop, tangential);
  for (const Axis other : {Axis::x, Axis::y, Axis::z}) {
    if (!periodic[index(other)])
      continue;
    const double gradient = other == axis ? pressure_drop / box.size()[index(axis)] : 0.0;
    faces[index(lower_face(other))] = faces[index(upper_face(other))] = Periodic{gradient};
  }
  return faces;
}

} // namespace pfv
