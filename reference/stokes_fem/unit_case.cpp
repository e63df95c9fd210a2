#include "reference/stokes_fem/unit_case.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reference::stokes_fem {

namespace {

// Shifts, then scales; equal pressures drive nothing, so their own size serves as the unit.
struct PressureRange {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();

  double unit() const {
    if (highest > lowest)
      return highest - lowest;
    return std::isfinite(highest) && highest != 0 ? std::abs(highest) : 1;
  }
};

PressureRange pressure_range(const pfv::FaceConditions& faces) {
  PressureRange range;
  for (const pfv::FaceCondition& face : faces)
    if (const auto* pressure = std::get_if<pfv::Pressure>(&face)) {
      range.lowest = std::min(range.lowest, pressure->value);
      range.highest = std::max(range.highest, pressure->value);
    }
  return range;
}

pfv::FaceConditions scaled(pfv::FaceConditions faces, double shift, double unit, double length) {
  for (pfv::FaceCondition& face : faces)
    if (auto* pressure = std::get_if<pfv::Pressure>(&face))
      pressure->value = (pressure->value - shift) / unit;
    else if (auto* periodic = std::get_if<pfv::Periodic>(&face))
      periodic->gradient *= length / unit;
  return faces;
}

} // namespace

UnitCase unit_case(const pfv::Case& problem) {
  const pfv::Box& box = problem.packing.box;
  const PressureRange range = pressure_range(problem.faces);
  const double largest_rise = imposed_gradient(problem.faces).cwiseProduct(box.size()).cwiseAbs().maxCoeff();
  const double pressure = largest_rise > 0 ? largest_rise : range.unit();
  const double length = box.size().maxCoeff();
  const double lowest = std::isfinite(range.lowest) ? range.lowest : 0;
  UnitCase unit{problem,
                scaled(problem.faces, lowest, pressure, length),
                lowest / pressure,
                box.lower,
                length,
                pressure,
                problem.fluid.viscosity};
  unit.problem.faces = scaled(problem.faces, 0, pressure, length);
  unit.problem.fluid.viscosity = 1;
  unit.problem.packing.box = {pfv::Vec3::Zero(), box.size() / unit.length};
  for (pfv::Sphere& sphere : unit.problem.packing.spheres)
    sphere = {(sphere.centre - unit.origin) / unit.length, sphere.radius / unit.length};
  return unit;
}

} // namespace reference::stokes_fem
