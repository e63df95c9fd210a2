#include "reference/stokes_fem/stokes_solver.hpp"

#include "pfv/problem/error.hpp"
#include "reference/stokes_fem/flux_imbalance.hpp"
#include "reference/stokes_fem/schur_complement.hpp"

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

void iterate(const SchurComplement& schur, const CommutatorPreconditioner& precondition,
             const VelocityComponents& components, const Boundary& boundary, const SolverSettings& settings,
             StokesSolution& solution) {
  Velocity velocity = schur.driven();
  VectorXd& pressure = solution.flow.pressure;
  VectorXd residual = -schur.divergence(velocity);
  pressure = VectorXd::Zero(residual.size());
  const double start = residual.norm();
  std::vector<Direction> directions;
  const auto check = [&] {
    solution.residual = start > 0 ? residual.norm() / start : 0;
    solution.face_flux = fluxes(velocity, components, boundary);
    solution.imbalance = flux_imbalance(solution.face_flux);
  };
  check();
  while (start > 0 && !converged(solution, settings)) {
    if (solution.iterations == settings.iterations)
      throw pfv::SolveError(not_converged(solution, settings));
    VectorXd direction = precondition(residual);
    orthogonalise(direction, directions);
    const Velocity response = schur.response(direction);
    VectorXd applied = schur.divergence(response);
    const double energy = direction.dot(applied);
    if (!(energy > 0))
      throw pfv::SolveError(not_converged(solution, settings) + "; no direction left");
    const double step = direction.dot(residual) / energy;
    pressure += step * direction;
    residual -= step * applied;
    for (std::size_t c = 0; c < 3; ++c)
      velocity[c] += step * response[c];
    directions.push_back({std::move(direction), std::move(applied), energy});
    ++solution.iterations;
    check();
  }
  for (std::size_t c = 0; c < 3; ++c) {
    solution.flow.velocity[c] = components[c].scatter(velocity[c]);
    solution.dissipation += components[c].load.dot(velocity[c]);
  }
}

} // namespace

StokesSolution solve_stokes(const StokesSystem& system, const Boundary& boundary, const pfv::FaceConditions& faces,
                            const SolverSettings& settings, pfv::Clock& clock) {
  StokesSolution solution;
  struct Factored {
    VelocityComponents components;
    SchurComplement schur{components};
    CommutatorPreconditioner precondition{components};
  };
  const auto factored = [&] {
    const auto timing = clock.stage("factor");
    return std::make_unique<Factored>(free_components(system, boundary, faces));
  }();
  for (const VelocityComponent& component : factored->components)
    solution.free_velocities += static_cast<std::size_t>(component.size);
  solution.factor_entries = factored->schur.factor_entries() + factored->precondition.factor_entries();
  const auto timing = clock.stage("solve");
  iterate(factored->schur, factored->precondition, factored->components, boundary, settings, solution);
  return solution;
}

} // namespace reference::stokes_fem
