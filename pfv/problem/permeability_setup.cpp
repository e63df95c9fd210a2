#include "pfv/problem/case.hpp"

namespace pfv {

namespace {

struct IsDriving {
  bool operator()(const SlipWall&) const { return false; }
  bool operator()(const Pressure&) const { return true; }
  bool operator()(const PressureProfile&) const { return true; }
  bool operator()(const Flux&) const { return true; }
  bool operator()(const Periodic& periodic) const { return periodic.gradient != 0; }
};

/// The one axis with a driving face.
std::optional<Axis> driven_axis(const FaceConditions& faces) {
  std::optional<Axis> axis;
  for (const Face face : all_faces) {
    if (!std::visit(IsDriving{}, faces[index(face)]))
      continue;
    if (axis && *axis != axis_of(face))
      return std::nullopt;
    axis = axis_of(face);
  }
  return axis;
}

} // namespace

std::optional<PermeabilitySetup> permeability_setup(const Case& problem) {
  const auto axis = driven_axis(problem.faces);
  if (!axis)
    return std::nullopt;
  const FaceCondition& lower = problem.faces[index(lower_face(*axis))];
  const FaceCondition& upper = problem.faces[index(upper_face(*axis))];
  const Box& box = problem.packing.box;
  const double length = box.size()[index(*axis)];
  PermeabilitySetup setup{*axis, std::nullopt, length, box.volume() / length};

  if (const auto* periodic = std::get_if<Periodic>(&lower)) {
    // A single point only sets the level: nothing can leave there.
    if (problem.pressure_points.size() > 1)
      return std::nullopt;
    setup.pressure_drop = periodic->gradient * length;
    return setup;
  }
  if (!problem.pressure_points.empty())
    return std::nullopt;
  const auto *low = std::get_if<Pressure>(&lower), *high = std::get_if<Pressure>(&upper);
  if (low && high && low->value != high->value) {
    setup.pressure_drop = high->value - low->value;
    return setup;
  }
  const auto *below = std::get_if<Flux>(&lower), *above = std::get_if<Flux>(&upper);
  if ((low && above && above->value != 0) || (high && below && below->value != 0))
    return setup;
  return std::nullopt;
}

} // namespace pfv
