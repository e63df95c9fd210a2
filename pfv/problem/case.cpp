#include "pfv/problem/case.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "pfv/problem/validate.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace pfv {

FaceConditions flow_along(Axis axis, double pressure_drop) {
  FaceConditions faces{};
  faces[index(lower_face(axis))] = Pressure{0};
  faces[index(upper_face(axis))] = Pressure{pressure_drop};
  return faces;
}

std::optional<PermeabilitySetup> permeability_setup(const Case& problem) {
  const auto open = [](const FaceCondition& condition) { return std::holds_alternative<Pressure>(condition); };
  if (std::ranges::count_if(problem.faces, open) != 2)
    return std::nullopt;
  const auto first = static_cast<Face>(std::ranges::find_if(problem.faces, open) - problem.faces.begin());
  const Axis axis = axis_of(first);
  const auto* lower = std::get_if<Pressure>(&problem.faces[index(lower_face(axis))]);
  const auto* upper = std::get_if<Pressure>(&problem.faces[index(upper_face(axis))]);
  if (!lower || !upper || lower->value == upper->value)
    return std::nullopt;
  const Box& box = problem.packing.box;
  const double length = box.size()[index(axis)];
  return PermeabilitySetup{axis, upper->value - lower->value, length, box.volume() / length};
}

void validate(const Fluid& fluid) {
  if (!(std::isfinite(fluid.viscosity) && fluid.viscosity > 0))
    throw InputError(fmt::format("viscosity \"{}\" must be a positive number (Pa s)", shortest(fluid.viscosity)));
}

void validate(const FaceConditions& faces) {
  bool driven = false;
  for (const Face face : all_faces)
    if (const auto* pressure = std::get_if<Pressure>(&faces[index(face)])) {
      driven = true;
      if (!std::isfinite(pressure->value))
        throw InputError(fmt::format("{} pressure \"{}\" must be a finite number (Pa)", face_names[index(face)],
                                     shortest(pressure->value)));
    }
  if (!driven)
    throw InputError("faces are all \"slip\"; at least one must carry a pressure, or the pressure has no level");
}

void validate(const Buoyancy& buoyancy) {
  if (!(std::isfinite(buoyancy.fluid_density) && buoyancy.fluid_density > 0))
    throw InputError(
        fmt::format("fluid_density \"{}\" must be a positive number (kg/m^3)", shortest(buoyancy.fluid_density)));
  if (!buoyancy.gravity.allFinite())
    throw InputError(fmt::format("gravity \"{}\" must be three finite numbers (m/s^2)", shortest(buoyancy.gravity)));
}

void validate(const Case& problem) {
  validate(problem.packing);
  validate(problem.fluid);
  validate(problem.faces);
  if (problem.buoyancy)
    validate(*problem.buoyancy);
}

} // namespace pfv
