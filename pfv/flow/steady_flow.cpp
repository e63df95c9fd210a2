#include "pfv/flow/steady_flow.hpp"

#include "pfv/flow/flux_faces.hpp"
#include "pfv/flow/fluxes.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/validate.hpp"

#include <algorithm>
#include <cmath>

namespace pfv {
namespace {

/// Of the first pore on the face: it is the same for all of them.
std::array<std::optional<double>, 6> pumped(const FlowSystem& system) {
  std::array<std::optional<double>, 6> pressure;
  for (const Face face : all_faces)
    if (std::holds_alternative<Flux>(system.faces[index(face)])) {
      const auto pore = std::ranges::find(system.source_of_pore, index(face)) - system.source_of_pore.begin();
      pressure[index(face)] = system.known_pressure[pore];
    }
  return pressure;
}

double pressure_on(const FaceCondition& condition, const std::optional<double>& pumped) {
  return pumped ? *pumped : std::get<Pressure>(condition).value;
}

std::optional<double> permeability(const Case& problem, const SteadyFlow& flow) {
  const auto setup = permeability_setup(problem);
  if (!setup)
    return std::nullopt;
  const int lower = index(lower_face(setup->axis)), upper = index(upper_face(setup->axis));
  const double drop = setup->pressure_drop ? *setup->pressure_drop
                                           : pressure_on(problem.faces[upper], flow.pumped[upper]) -
                                                 pressure_on(problem.faces[lower], flow.pumped[lower]);
  return problem.fluid.viscosity * flow.face_flux[lower] * setup->length / (setup->area * drop);
}

void add_fluxes(SteadyFlow& flow) {
  const Outflow out = outflow(flow.network, flow.system, flow.pressure);
  flow.face_flux = out.face;
  flow.point_flux = out.point;
  const auto add = [&](double flux) { (flux > 0 ? flow.flux_out : flow.flux_in) += std::abs(flux); };
  std::ranges::for_each(out.face, add);
  std::ranges::for_each(out.point, add);
  if (!std::isfinite(flow.flux_in + flow.flux_out))
    throw SolveError("the flow is not finite");
  flow.pumped = pumped(flow.system);
  if (!flow.system.offset.empty())
    flow.mean_flux = mean_flux(flow.network, flow.system, flow.pressure);
}

} // namespace

double SteadyFlow::imbalance() const {
  const double larger = std::max(flux_in, flux_out);
  return larger > 0 ? std::abs(flux_in - flux_out) / larger : 0;
}

SteadyFlow solve_steady_flow(const Case& problem, const FlowOptions& options, Clock& clock) {
  validate_level(problem.faces, problem.pressure_points);
  SteadyFlow flow;
  flow.network = build_pore_network(problem.packing, periodic_axes(problem.faces), clock);
  Conductances throats;
  {
    const auto timing = clock.stage("conductances");
    throats = conductances(flow.network, options.conductance, options.walls, problem.fluid.viscosity);
  }
  {
    const auto timing = clock.stage("assemble");
    flow.system = assemble(flow.network, std::move(throats), problem.faces, problem.pressure_points);
  }
  const auto solver = make_solver(options.solver);
  {
    const auto timing = clock.stage("factor");
    solver->analyse(flow.system.matrix);
    solver->factor(flow.system.matrix);
  }
  {
    const auto timing = clock.stage("solve");
    Eigen::VectorXd solution;
    solve_with_flux_faces(flow.network, flow.system, *solver, solution);
    flow.pressure = pore_pressures(flow.system, solution);
    flow.solver = solver->report();
    add_fluxes(flow);
  }
  flow.permeability = permeability(problem, flow);
  {
    const auto timing = clock.stage("forces");
    flow.forces = fluid_forces(flow.network, flow.pressure, problem.buoyancy);
  }
  return flow;
}

} // namespace pfv
