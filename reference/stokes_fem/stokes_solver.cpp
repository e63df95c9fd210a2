#include "reference/stokes_fem/stokes_solver.hpp"

#include "pfv/problem/error.hpp"
#include "reference/stokes_fem/flux_imbalance.hpp"
#include "reference/stokes_fem/schur_complement.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace reference::stokes_fem {

namespace {

using Eigen::VectorXd;

struct Direction {
  VectorXd pressure;
  VectorXd applied; // S pressure
  double energy;    // pressure . S pressure
};

void orthogonalise(VectorXd& pressure, const std::vector<Direction>& directions) {
  for (const Direction& direction : directions)
    pressure -= pressure.dot(direction.applied) / direction.energy * direction.pressure;
}

std::array<double, 6> fluxes(const Velocity& velocity, const VelocityComponents& components, const Boundary& boundary) {
  std::array<double, 6> flux{};
  for (const pfv::Face face : pfv::all_faces) {
    const auto f = static_cast<std::size_t>(index(face));
    const auto c = static_cast<std::size_t>(index(axis_of(face)));
    if (boundary.face_weight[f].size() != 0)
      flux[f] = (is_upper(face) ? 1 : -1) * components[c].gather(boundary.face_weight[f]).dot(velocity[c]);
  }
  return flux;
}

bool converged(const StokesSolution& solution, const SolverSettings& settings) {
  return solution.residual < settings.residual && solution.imbalance < settings.imbalance;
}

std::string not_converged(const StokesSolution& solution, const SolverSettings& settings) {
  char text[200];
  std::snprintf(
      text, sizeof text,
      "Stokes solver: after %d iterations residual %.1e (%.1e allowed), |inflow/outflow - 1| %.1e (%.1e allowed)",
      solution.iterations, solution.residual, settings.residual, solution.imbalance, settings.imbalance);
  return text;
}

double norm(const Velocity& velocity) {
  return std::sqrt(velocity[0].squaredNorm() + velocity[1].squaredNorm() + velocity[2].squaredNorm());
}

struct Factored {
  Factored(const StokesSystem& system, const Boundary& boundary, const pfv::FaceConditions& faces,
           const InnerSolves& solves)
      : components(free_components(system, boundary, faces)), laplacian(node_laplacian(system.laplacian, components)),
        velocities(std::holds_alternative<Direct>(solves)
                       ? make_direct_velocity_solver(system.laplacian, components)
                       : make_multigrid_velocity_solver(laplacian, components, system.ends)),
        precondition(components, laplacian,
                     std::holds_alternative<Direct>(solves) ? make_direct_pressure_solver
                                                            : make_multigrid_pressure_solver) {}

  VelocityComponents components;
  NodeLaplacian laplacian;
  std::unique_ptr<VelocitySolver> velocities;
  CommutatorPreconditioner precondition;

  Velocity load() const { return {components[0].load, components[1].load, components[2].load}; }

  /// load + B^T pressure - A velocity.
  Velocity momentum_defect(const Velocity& velocity, const VectorXd& pressure) const {
    Velocity defect = gradient(components, pressure);
    const Velocity applied = laplacian.scatter(laplacian * laplacian.gather(velocity, components), components);
    for (std::size_t c = 0; c < 3; ++c)
      defect[c] += components[c].load - applied[c];
    return defect;
  }
};

/// As exact as the step it is for: the further the residual has come down, the smaller what is still added (Simoncini
/// and Szyld 2003, SIAM J. Sci. Comput. 25, 454).
double velocity_tolerance(const StokesSolution& solution, const SolverSettings& settings) {
  return std::clamp(0.1 * settings.residual / solution.residual, 0.1 * settings.residual, 1e-2);
}

/// The flow so far; its residual is the divergence, whatever the velocity solves left of the momentum.
struct Iterate {
  Velocity velocity;
  VectorXd residual;
};

void descend(const Factored& problem, const Boundary& boundary, const SolverSettings& settings, double start,
             Iterate& flow, StokesSolution& solution) {
  std::vector<Direction> directions;
  const auto check = [&] {
    solution.residual = start > 0 ? flow.residual.norm() / start : 0;
    solution.face_flux = fluxes(flow.velocity, problem.components, boundary);
    solution.imbalance = flux_imbalance(solution.face_flux);
  };
  check();
  while (start > 0 && !converged(solution, settings)) {
    if (solution.iterations == settings.iterations)
      throw pfv::SolveError(not_converged(solution, settings));
    VectorXd direction = problem.precondition(flow.residual);
    orthogonalise(direction, directions);
    const Velocity response =
        problem.velocities->solve(gradient(problem.components, direction), velocity_tolerance(solution, settings));
    VectorXd applied = divergence(problem.components, response);
    const double energy = direction.dot(applied);
    if (!(energy > 0))
      throw pfv::SolveError(not_converged(solution, settings) + "; no direction left");
    const double step = direction.dot(flow.residual) / energy;
    solution.flow.pressure += step * direction;
    flow.residual -= step * applied;
    for (std::size_t c = 0; c < 3; ++c)
      flow.velocity[c] += step * response[c];
    directions.push_back({std::move(direction), std::move(applied), energy});
    ++solution.iterations;
    check();
  }
}

void iterate(const Factored& problem, const Boundary& boundary, const SolverSettings& settings,
             StokesSolution& solution) {
  const Velocity load = problem.load();
  Iterate flow{problem.velocities->solve(load, 0.1 * settings.residual), {}};
  flow.residual = -divergence(problem.components, flow.velocity);
  solution.flow.pressure = VectorXd::Zero(flow.residual.size());
  const double start = flow.residual.norm();
  descend(problem, boundary, settings, start, flow, solution);
  // What inexact solves left adds up; one more solve takes it away, and the divergence that this brings follows.
  for (;;) {
    const Velocity defect = problem.momentum_defect(flow.velocity, solution.flow.pressure);
    solution.momentum_residual = start > 0 ? norm(defect) / norm(load) : 0;
    if (solution.momentum_residual < settings.momentum)
      break;
    if (solution.corrections == settings.corrections)
      throw pfv::SolveError(not_converged(solution, settings) + "; the momentum stays out of balance");
    ++solution.corrections;
    const Velocity correction =
        problem.velocities->solve(defect, std::min(0.1, 0.1 * settings.momentum / solution.momentum_residual));
    for (std::size_t c = 0; c < 3; ++c)
      flow.velocity[c] += correction[c];
    flow.residual -= divergence(problem.components, correction);
    descend(problem, boundary, settings, start, flow, solution);
  }
  for (std::size_t c = 0; c < 3; ++c) {
    solution.flow.velocity[c] = problem.components[c].scatter(flow.velocity[c]);
    solution.dissipation += load[c].dot(flow.velocity[c]);
  }
}

} // namespace

StokesSolution solve_stokes(const StokesSystem& system, const Boundary& boundary, const pfv::FaceConditions& faces,
                            const SolverSettings& settings, pfv::Clock& clock) {
  StokesSolution solution;
  const auto factored = [&] {
    const auto timing = clock.stage("factor");
    return std::make_unique<Factored>(system, boundary, faces, settings.inner);
  }();
  for (const VelocityComponent& component : factored->components)
    solution.free_velocities += static_cast<std::size_t>(component.size);
  solution.factor_entries = factored->velocities->factor_entries() + factored->precondition.factor_entries();
  const auto timing = clock.stage("solve");
  iterate(*factored, boundary, settings, solution);
  solution.velocity_iterations = factored->velocities->iterations();
  return solution;
}

} // namespace reference::stokes_fem
