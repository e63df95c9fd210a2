#include "pfv/flow/steady_flow.hpp"

#include "pfv/flow/flux_faces.hpp"
#include "pfv/flow/fluxes.hpp"
#include "pfv/huge_pages.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/validate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pfv {
namespace {

constexpr double balanced = 3e-9; // of the flux
constexpr int most_attempts = 12;

/// Of the first pore on the face: it is the same for all of them.
std::array<std::optional<double>, 6> pumped(const FlowSystem& system) {
  std::array<std::optional<double>, 6> pressure;
  for (const Face face : all_faces)
    if (std::holds_alternative<Flux>(system.faces[index(face)])) {
      pressure[index(face)] =
          std::ranges::find(system.known_pores, index(face), &FlowSystem::KnownPore::source)->pressure;
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

/// The unknowns where the pressure would be if it fell evenly from face to face; nothing when that is not the question.
Eigen::VectorXd even_fall(const Case& problem, const SteadyFlow& flow) {
  const auto setup = permeability_setup(problem);
  if (!setup || !setup->pressure_drop || !imposed_gradient(problem.faces).isZero(0))
    return {};
  const int axis = index(setup->axis);
  const double middle = 0.5 * (flow.network.box.lower[axis] + flow.network.box.upper[axis]);
  Eigen::VectorXd guess = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(flow.system.unknowns()));
  for (std::size_t i = 0; i < flow.network.pores.size(); ++i)
    if (const int unknown = flow.system.unknown_of_pore[i]; unknown >= 0)
      guess[unknown] = *setup->pressure_drop * (flow.network.pores.centre[i][axis] - middle) / setup->length;
  return guess;
}

void set_fluxes(SteadyFlow& flow) {
  const Outflow out = outflow(flow.network, flow.system, flow.pressure);
  flow.face_flux = out.face;
  flow.point_flux = out.point;
  flow.flux_in = flow.flux_out = 0;
  const auto add = [&](double flux) { (flux > 0 ? flow.flux_out : flow.flux_in) += std::abs(flux); };
  std::ranges::for_each(out.face, add);
  std::ranges::for_each(out.point, add);
  if (!std::isfinite(flow.flux_in + flow.flux_out))
    throw SolveError("the flow is not finite");
  flow.pumped = pumped(flow.system);
  if (!flow.system.offset.empty())
    flow.mean_flux = mean_flux(flow.network, flow.system, flow.pressure);
}

/// No pressure leaves those that are imposed, where nothing is pumped and none rises from box to box. Pores that hang
/// on all others by throats that conduct 1e-16 of those among themselves get theirs from round-off: what lies outside
/// is set to the nearest bound, which moves fluxes by as little. Returns how many were.
std::size_t clamp(SteadyFlow& flow) {
  constexpr double slack = 1e-9; // of the difference of the bounds: what a solver may leave
  const auto pumps = [](const FaceCondition& face) { return std::holds_alternative<Flux>(face); };
  if (!flow.system.rise.isZero(0) || std::ranges::any_of(flow.system.faces, pumps))
    return 0;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const FlowSystem::KnownPore& known : flow.system.known_pores)
    if (known.source >= 0) {
      least = std::min(least, known.pressure);
      most = std::max(most, known.pressure);
    }
  std::size_t outside = 0;
  for (double& pressure : flow.pressure)
    if (pressure < least - slack * (most - least) || pressure > most + slack * (most - least)) {
      pressure = std::clamp(pressure, least, most);
      ++outside;
    }
  return outside;
}

void stop(SteadyFlow& flow) {
  flow.face_flux = {};
  std::ranges::fill(flow.point_flux, 0);
  flow.flux_in = flow.flux_out = 0;
}

} // namespace

double SteadyFlow::imbalance() const {
  const double larger = std::max(flux_in, flux_out);
  return larger > 0 ? std::abs(flux_in - flux_out) / larger : 0;
}

FollowedFlow::FollowedFlow(const Case& problem, const FlowOptions& options, Clock& clock)
    : FollowedFlow(WithoutForces{}, problem, options, clock) {
  find_forces(clock);
}

FollowedFlow::FollowedFlow(WithoutForces /*tag*/, const Case& problem, const FlowOptions& options, Clock& clock)
    : question_(problem), options_(options), solver_(make_solver(options.solver)),
      spread_shear_(shear_spread(options.conductance), problem.faces, options.walls) {
  validate_level(problem.faces, problem.pressure_points);
  constexpr std::size_t bytes_per_sphere = 800; // of the triangulation; what comes later goes along memory
  prefer_huge_pages(bytes_per_sphere * problem.packing.spheres.size());
  question_.packing.spheres.clear();
  question_.packing.spheres.shrink_to_fit();
  flow_.network =
      build_pore_network(problem.packing, periodic_axes(problem.faces), clock, reads_openings(options.conductance));
  Conductances throats;
  {
    const auto timing = clock.stage("conductances");
    throats = conductances(flow_.network, options_.conductance, options_.walls, question_.fluid.viscosity);
  }
  if (!options_.keep_shapes)
    flow_.network.throats.forget_shapes();
  {
    const auto timing = clock.stage("assemble");
    flow_.system = assemble(flow_.network, std::move(throats), question_.faces, question_.pressure_points);
  }
  factor(clock);
  solution_ = even_fall(question_, flow_);
  solve(clock);
}

FollowedFlow::~FollowedFlow() = default;

void FollowedFlow::follow(const Packing& packing, Clock& clock) {
  question_.packing.box = packing.box;
  flow_.network.throats.make_room_for_shapes(reads_openings(options_.conductance));
  pfv::follow(flow_.network, packing, clock);
  {
    const auto timing = clock.stage("conductances");
    update(throats_, flow_.network, options_.conductance, options_.walls, question_.fluid.viscosity);
  }
  bool same_pattern;
  {
    const auto timing = clock.stage("assemble");
    same_pattern = refresh(flow_.system, flow_.network, throats_);
    if (!same_pattern)
      flow_.system = assemble(flow_.network, throats_, question_.faces, question_.pressure_points);
  }
  if (same_pattern) {
    const auto timing = clock.stage("factor");
    solver_->update(flow_.system.matrix);
  } else {
    factor(clock);
  }
  solve(clock);
  find_forces(clock);
}

void FollowedFlow::factor(Clock& clock) {
  const auto timing = clock.stage("factor");
  solver_->analyse(flow_.system.matrix);
  solver_->factor(flow_.system.matrix);
}

void FollowedFlow::solve(Clock& clock) {
  const auto timing = clock.stage("solve");
  int iterations = 0;
  // Where little flows through throats that conduct well, pressures that are right are not yet fluxes that balance.
  for (int attempt = 0; attempt == 0 || (attempt < most_attempts && flow_.imbalance() > balanced); ++attempt) {
    solve_with_flux_faces(flow_.network, flow_.system, *solver_, solution_);
    set_pore_pressures(flow_.system, solution_, flow_.pressure);
    flow_.clamped_pores = clamp(flow_);
    set_fluxes(flow_);
    iterations += solver_->report().iterations;
    if (flow_.imbalance() > balanced && !has_way(flow_.system, flow_.network))
      stop(flow_);
  }
  flow_.solver = solver_->report();
  flow_.solver.iterations = iterations;
  flow_.permeability = permeability(question_, flow_);
}

void FollowedFlow::find_forces(Clock& clock) {
  const auto timing = clock.stage("forces");
  update(flow_.forces, flow_.network, flow_.system, flow_.pressure, options_.walls, question_.buoyancy);
  spread_shear_(flow_.network, flow_.forces);
}

SteadyFlow solve_steady_flow(const Case& problem, const FlowOptions& options, Clock& clock) {
  FollowedFlow flow(FollowedFlow::WithoutForces{}, problem, options, clock);
  flow.solver_.reset(); // a third of all memory
  flow.solution_.resize(0);
  flow.find_forces(clock);
  return std::move(flow.flow_);
}

} // namespace pfv
