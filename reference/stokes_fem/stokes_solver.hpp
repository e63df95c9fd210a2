#pragma once

#include "pfv/clock.hpp"
#include "reference/stokes_fem/stokes_system.hpp"
#include "reference/stokes_fem/tractions.hpp"

#include <cstddef>
#include <variant>

namespace reference::stokes_fem {

struct Direct {};    // Cholesky factors
struct Multigrid {}; // conjugate gradients with multigrids, each velocity solve as exact as its step asks for
using InnerSolves = std::variant<Multigrid, Direct>;

struct SolverSettings {
  InnerSolves inner = {};
  double residual = 1e-9;  // of the discrete divergence, in units of its norm at zero pressure
  double imbalance = 1e-6; // |inflow / outflow - 1|
  double momentum = 1e-8;  // norm of the momentum equation's residual over that of the load
  int iterations = 200;
  int corrections = 5; // velocity solves for what is left of the momentum equation
};

struct StokesSolution {
  FlowField flow;
  std::array<double, 6> face_flux{}; // by pfv::Face, out of the box
  double dissipation = 0;            // sum of - p Q_out over the pressure faces, of the drop times Q along a
                                     // mean gradient; = integral of |grad u|^2
  double residual = 0;
  double imbalance = 0;
  double momentum_residual = 0;
  int iterations = 0;
  int corrections = 0;
  int velocity_iterations = 0;     // of all velocity solves
  std::size_t free_velocities = 0; // unknowns that no boundary condition fixes
  double factor_entries = 0;       // nonzeros of all Cholesky factors
};

/// Solves Stokes' equations driven by the pressure faces or the mean gradient: conjugate gradients on the pressure
/// Schur complement (Uzawa), the commutator preconditioner, every search direction kept and orthogonalised against,
/// from zero pressure. Times "factor" and "solve". Throws pfv::SolveError when a
/// factorisation fails or the settings are not met.
StokesSolution solve_stokes(const StokesSystem& system, const Boundary& boundary, const pfv::FaceConditions& faces,
                            const SolverSettings& settings, pfv::Clock& clock);

} // namespace reference::stokes_fem
