#include "pfv/flow/steady_flow.hpp"

#include "pfv/problem/error.hpp"

#include <algorithm>
#include <cmath>

namespace pfv {
namespace {

std::optional<double> permeability(const Case& problem, const std::array<double, 6>& face_flux) {
  const auto setup = permeability_setup(problem);
  if (!setup)
    return std::nullopt;
  const double flux = face_flux[index(lower_face(setup->axis))];
  return problem.fluid.viscosity * flux * setup->length / (setup->area * setup->pressure_drop);
}

} // namespace

SteadyFlow solve_steady_flow(const Case& problem, const FlowOptions& options, Clock& clock) {
  if (std::ranges::none_of(problem.faces, [](const auto& face) { return std::holds_alternative<Pressure>(face); }))
    throw InputError("no face has a pressure: at least one must, or the flow has no cause");
  SteadyFlow flow;
  flow.network = build_pore_network(problem.packing, clock);
  Conductances throat_conductances;
  {
    const auto timing = clock.stage("conductances");
    throat_conductances = conductances(flow.network, options.conductance, options.walls, problem.fluid.viscosity);
  }
  {
    const auto timing = clock.stage("assemble");
    flow.system = assemble(flow.network, throat_conductances, problem.faces);
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
    solver->solve(flow.system.right_side, solution);
    flow.pressure = pore_pressures(flow.system, solution);
    flow.solver = solver->report();
    flow.face_flux = face_fluxes(flow.network, flow.system, flow.pressure);
  }
  for (const double flux : flow.face_flux)
    (flux > 0 ? flow.flux_out : flow.flux_in) += std::abs(flux);
  if (!std::isfinite(flow.flux_in + flow.flux_out))
    throw SolveError("the flow is not finite");
  flow.permeability = permeability(problem, flow.face_flux);
  {
    const auto timing = clock.stage("forces");
    flow.forces = fluid_forces(flow.network, flow.pressure, problem.buoyancy);
  }
  return flow;
}

} // namespace pfv
