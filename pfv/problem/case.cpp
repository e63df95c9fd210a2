#include "pfv/problem/case.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "pfv/problem/validate.hpp"

#include <cmath>
#include <fmt/format.h>

namespace pfv {

void validate(const Fluid& fluid) {
  if (!(std::isfinite(fluid.viscosity) && fluid.viscosity > 0))
    throw InputError(fmt::format("viscosity \"{}\" must be a positive number (Pa s)", shortest(fluid.viscosity)));
}

void validate(const PressurePoint& point, const Box& box) {
  const auto at = point.position.array();
  if (!point.position.allFinite() || (at < box.lower.array()).any() || (at > box.upper.array()).any())
    throw InputError(fmt::format("position \"{}\" of a pressure point must lie in the box \"{} {}\" (m)",
                                 shortest(point.position), shortest(box.lower), shortest(box.upper)));
  if (!std::isfinite(point.value))
    throw InputError(
        fmt::format("pressure \"{}\" of a pressure point must be a finite number (Pa)", shortest(point.value)));
}

void validate(const Buoyancy& buoyancy) {
  if (!(std::isfinite(buoyancy.fluid_density) && buoyancy.fluid_density > 0))
    throw InputError(
        fmt::format("fluid_density \"{}\" must be a positive number (kg/m^3)", shortest(buoyancy.fluid_density)));
  if (!buoyancy.gravity.allFinite())
    throw InputError(fmt::format("gravity \"{}\" must be three finite numbers (m/s^2)", shortest(buoyancy.gravity)));
}

void validate(const Case& problem) {
  validate(problem.packing, {}, periodic_axes(problem.faces));
  validate(problem.fluid);
  validate(problem.faces);
  for (const PressurePoint& point : problem.pressure_points)
    validate(point, problem.packing.box);
  validate_level(problem.faces, problem.pressure_points);
  if (problem.buoyancy)
    validate(*problem.buoyancy);
}

} // namespace pfv
