#include "studies/runner/sample_tables.hpp"

#include "pfv/pores/pore_network.hpp"
#include "pfv/problem/error.hpp"
#include "reference/probes.hpp"

#include <cmath>
#include <fmt/format.h>

namespace studies {
namespace {

std::string number(double value, int digits = 6) {
  return std::isnan(value) ? std::string() : fmt::format("{:.{}g}", value, digits);
}

std::string error_of(const std::optional<BoundedField>& field) {
  return field && field->error ? number(*field->error, 3) : std::string();
}

std::string place(const pfv::Vec3& point) {
  return fmt::format("{},{},{}", number(point.x(), 10), number(point.y(), 10), number(point.z(), 10));
}

/// m^2, solid and fluid.
double area(const reference::Probes::Facet& facet) {
  pfv::Vec3 sum = pfv::Vec3::Zero();
  for (std::size_t c = 1; c + 1 < facet.size(); ++c)
    sum += 0.5 * (facet[c] - facet[0]).cross(facet[c + 1] - facet[0]);
  return sum.norm();
}

void require_same(std::size_t found, std::size_t here, const Finding& finding, const char* what) {
  if (found != here)
    throw pfv::InputError(fmt::format("{} of {} has {} \"{}\", PFV {} now: run it again", finding.method,
                                      finding.case_id, what, found, here));
}

void add_throats(const pfv::PoreNetwork& network, const std::vector<reference::Probes::Facet>& facets, double rise,
                 int axis, const Finding& finding, std::string& text) {
  const auto& throats = network.throats;
  for (std::size_t t = 0; t < throats.size(); ++t) {
    int walls = 0;
    const auto corners = network.corners(t);
    for (int c = 0; c < 3; ++c)
      walls += pfv::is_wall(corners[c]) ? 1 : 0;
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", finding.case_id, throats.pores[t][0], throats.pores[t][1],
                        walls, number(area(facets[t])), number(throats.fluid_area[t]), number(throats.void_volume[t]),
                        number(throats.wetted_surface[t]), number(throats.length[t]),
                        number(finding.throat_fluxes->values[t]),
                        number(throats.shift.empty() ? 0 : throats.shift[t][axis] * rise));
  }
}

} // namespace

void add_samples(const pfv::Case& problem, const Finding& finding, SampleTables& tables) {
  const auto setup = permeability_setup(problem);
  if (!setup || !finding.permeability || !finding.forces || !finding.pore_pressures || !finding.throat_fluxes)
    throw pfv::InputError(
        fmt::format("{} of {} has no samples of a flow along an axis", finding.method, finding.case_id));
  const auto& spheres = problem.packing.spheres;
  pfv::Clock clock;
  const auto network = build_pore_network(problem.packing, periodic_axes(problem.faces), clock);
  const auto facets = reference::pore_probes(problem, network).probes.facets;
  require_same(finding.pore_pressures->values.size(), network.pores.size(), finding, "pores");
  require_same(finding.throat_fluxes->values.size(), network.throats.size(), finding, "throats");

  const double drop = finding.pressure_drop.value_or(std::nan(""));
  tables.permeabilities += fmt::format(
      "{},{},{},{},{},{},{},{},{}\n", finding.case_id, spheres.size(), number(1 - network.porosity()),
      number(finding.permeability->value), finding.permeability->error ? number(*finding.permeability->error, 3) : "",
      number(drop), error_of(finding.forces), error_of(finding.pore_pressures), error_of(finding.throat_fluxes));
  for (std::size_t s = 0; s < spheres.size(); ++s) {
    const double* force = &finding.forces->values[3 * s];
    tables.forces += fmt::format("{},{},{},{},{},{}\n", finding.case_id, place(spheres[s].centre),
                                 number(spheres[s].radius, 10), number(force[0]), number(force[1]), number(force[2]));
  }
  for (std::size_t i = 0; i < network.pores.size(); ++i)
    tables.pores += fmt::format("{},{},{},{}\n", finding.case_id, place(network.pores.centre[i]),
                                number(network.pores.void_volume[i]), number(finding.pore_pressures->values[i]));
  add_throats(network, facets, setup->pressure_drop.value_or(0), pfv::index(setup->axis), finding, tables.throats);
}

} // namespace studies
