#include "reference/pore_volumes/sample.hpp"

#include "pfv/flow/containing_pore.hpp"
#include "pfv/flow/fluxes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reference {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// Whether a point lies in a sphere or in the image of one.
bool in_solid(const pfv::PoreNetwork& network, const pfv::Vec3& point) {
  return std::ranges::any_of(network.sites.spheres, [&](const pfv::Sphere& sphere) {
    return (point - sphere.centre).squaredNorm() < sphere.radius * sphere.radius;
  });
}

double pressure_at(const pfv::SteadyFlow& flow, const pfv::Vec3& point) {
  if (in_solid(flow.network, point))
    return unknown;
  const auto [pore, shift] = pfv::containing_pore(flow.network, point);
  return flow.pressure[static_cast<std::size_t>(pore)] - pfv::along(flow.system.rise, shift);
}

} // namespace

void sample(const pfv::SteadyFlow& flow, const Probes& probes, Answer& answer) {
  const auto& centres = flow.network.pores.centre;
  const bool of_pores =
      probes.points.size() >= centres.size() && std::equal(centres.begin(), centres.end(), probes.points.begin());
  answer.point_pressures.emplace();
  answer.point_pressures->reserve(probes.points.size());
  for (std::size_t i = 0; i < probes.points.size(); ++i)
    answer.point_pressures->push_back(of_pores && i < centres.size() ? flow.pressure[i]
                                                                     : pressure_at(flow, probes.points[i]));
  answer.facet_fluxes.emplace(probes.facets.size(), unknown);
  if (of_pores && probes.facets.size() == flow.network.throats.size())
    for (std::size_t throat = 0; throat < probes.facets.size(); ++throat)
      (*answer.facet_fluxes)[throat] = pfv::throat_flux(flow.network, flow.system, flow.pressure, throat);
}

} // namespace reference
