#include "pfv/flow/permeability_error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace pfv {
namespace {

double radius_ratio(const Packing& packing) {
  const auto [smallest, largest] = std::ranges::minmax(packing.spheres, {}, &Sphere::radius);
  return largest.radius / smallest.radius;
}

} // namespace

std::optional<PermeabilityError> permeability_error(const FlowOptions& options, const Packing& packing,
                                                    double porosity) {
  using Rule = Calibrated;
  if (!std::holds_alternative<Rule>(options.conductance))
    return std::nullopt;
  const double solid = 1 - porosity, ratio = radius_ratio(packing);
  if (!std::holds_alternative<MirrorWalls>(options.walls))
    return PermeabilityError{{}, "fitted with mirror walls"};
  if (solid < Rule::least_solid_fraction || solid > Rule::largest_solid_fraction)
    return PermeabilityError{{},
                             fmt::format("fitted at solid fractions of {} to {}, this is {:.2g}",
                                         Rule::least_solid_fraction, Rule::largest_solid_fraction, solid)};
  if (ratio > Rule::largest_radius_ratio)
    return PermeabilityError{
        {}, fmt::format("fitted up to a radius ratio of {}, this is {:.2g}", Rule::largest_radius_ratio, ratio)};
  return PermeabilityError{Rule::permeability_error, {}};
}

} // namespace pfv
