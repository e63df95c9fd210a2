#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "pfv/problem/validate.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pfv {

namespace {

std::string quoted(const FaceCondition& condition) {
  struct Text {
    std::string operator()(const SlipWall&) const { return "slip"; }
    std::string operator()(const Pressure& pressure) const { return "pressure " + shortest(pressure.value); }
    std::string operator()(const PressureProfile&) const { return "pressure profile"; }
    std::string operator()(const Flux& flux) const { return "flux " + shortest(flux.value); }
    std::string operator()(const Periodic& periodic) const { return "periodic " + shortest(periodic.gradient); }
  };
  return fmt::format("\"{}\"", std::visit(Text{}, condition));
}

void validate_finite(std::string_view face, std::string_view what, double value, std::string_view unit) {
  if (!std::isfinite(value))
    throw InputError(fmt::format("{} {} \"{}\" must be a finite number ({})", face, what, shortest(value), unit));
}

/// Pressures at places, which `what` calls them.
template <class Point>
void validate_points(std::string_view face, const std::vector<Point>& points, double Point::*place,
                     std::string_view what, std::string_view unit) {
  if (points.empty())
    throw InputError(fmt::format("{} pressure \"[]\" must be a number or at least one [{}, pressure]", face, what));
  for (const Point& point : points) {
    validate_finite(face, what, point.*place, unit);
    validate_finite(face, "pressure", point.pressure, "Pa");
  }
  const auto turn = std::ranges::adjacent_find(points, std::ranges::greater_equal{}, place);
  if (turn != points.end())
    throw InputError(fmt::format("{} {} \"{}\" must be beyond the one before it, {} ({})", face, what,
                                 shortest(turn[1].*place), shortest(turn[0].*place), unit));
}

/// One condition by itself.
struct ValidateCondition {
  Face face;

  std::string_view name() const { return face_names[index(face)]; }

  void finite(std::string_view what, double value, std::string_view unit) const {
    validate_finite(name(), what, value, unit);
  }

  void operator()(const SlipWall&) const {}
  void operator()(const Pressure& pressure) const { finite("pressure", pressure.value, "Pa"); }
  void operator()(const Flux& flux) const { finite("flux", flux.value, "m^3/s"); }
  void operator()(const Periodic& periodic) const { finite("gradient", periodic.gradient, "Pa/m"); }
  void operator()(const PressureProfile& profile) const {
    if (profile.along == axis_of(face))
      throw InputError(fmt::format("{} pressure along \"{}\" must be along an axis of the face, not the one across it",
                                   name(), axis_names[index(profile.along)]));
    validate_points(name(), profile.points, &PressureProfile::Point::position, "position", "m");
  }
};

void validate_pair(const FaceConditions& faces, Axis axis) {
  const Face lower = lower_face(axis), upper = upper_face(axis);
  const auto *a = std::get_if<Periodic>(&faces[index(lower)]), *b = std::get_if<Periodic>(&faces[index(upper)]);
  if ((a || b) && !(a && b && *a == *b))
    throw InputError(fmt::format("{} {} and {} {} must both be periodic with the same gradient (Pa/m)",
                                 face_names[index(lower)], quoted(faces[index(lower)]), face_names[index(upper)],
                                 quoted(faces[index(upper)])));
}

/// What an open face cannot stand beside: its pressure would have to repeat and rise at once.
void validate_beside(const FaceConditions& faces, Axis periodic) {
  const double gradient = imposed_gradient(faces)[index(periodic)];
  for (const Face face : all_faces) {
    const FaceCondition& condition = faces[index(face)];
    const bool open = !std::holds_alternative<SlipWall>(condition) && !std::holds_alternative<Periodic>(condition);
    if (open && gradient != 0)
      throw InputError(fmt::format("{} {} must be \"slip\" or periodic beside the gradient \"{}\" along {}",
                                   face_names[index(face)], quoted(condition), shortest(gradient),
                                   axis_names[index(periodic)]));
    const auto* profile = std::get_if<PressureProfile>(&condition);
    if (profile && profile->along == periodic)
      throw InputError(fmt::format("{} pressure along \"{}\" must be along an axis that is not periodic",
                                   face_names[index(face)], axis_names[index(periodic)]));
  }
}

} // namespace

void validate(const FaceConditions& faces) {
  for (const Face face : all_faces)
    std::visit(ValidateCondition{face}, faces[index(face)]);
  for (const Axis axis : {Axis::x, Axis::y, Axis::z})
    validate_pair(faces, axis);
  const PeriodicAxes periodic = periodic_axes(faces);
  for (const Axis axis : {Axis::x, Axis::y, Axis::z})
    if (periodic[index(axis)])
      validate_beside(faces, axis);
}

void validate(const PressureInTime& pressure, Face face) {
  validate_points(face_names[index(face)], pressure.points, &PressureInTime::Point::time, "time", "s");
}

void validate_level(const FaceConditions& faces, std::span<const PressurePoint> points, std::string_view or_else) {
  const auto known = [](const FaceCondition& face) {
    return std::holds_alternative<Pressure>(face) || std::holds_alternative<PressureProfile>(face);
  };
  if (!points.empty() || std::ranges::any_of(faces, known) || !imposed_gradient(faces).isZero(0))
    return;
  std::vector<std::string> conditions;
  for (const FaceCondition& face : faces)
    conditions.push_back(quoted(face));
  throw InputError(fmt::format("faces {} leave the pressure without a level; at least one face or point must have a "
                               "pressure, {}",
                               fmt::join(conditions, ", "), or_else));
}

} // namespace pfv
