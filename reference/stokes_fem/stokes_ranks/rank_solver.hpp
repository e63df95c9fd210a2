#pragma once

#include "reference/stokes_fem/stokes_ranks/block_preconditioner.hpp"

namespace reference::stokes_fem {

struct RankSolverSettings {
  double residual = 1e-8;  // of all equations, in the preconditioner's norm, in units of that of the load
  double imbalance = 1e-7; // |inflow / outflow - 1|
  int iterations = 2000;
};

struct RankSolution {
  OwnedVec velocity;
  OwnedVec pressure;
  std::array<double, 6> face_flux{}; // by pfv::Face, out of the box
  double dissipation = 0;            // load . u = integral of |grad u|^2
  double residual = 0;
  double imbalance = 0;
  int iterations = 0;
};

/// Minimal residuals (Paige, Saunders 1975, SIAM J. Numer. Anal. 12, 617) on velocities and pressures together, from
/// zero: a few vectors whatever the number of iterations. Throws std::runtime_error when the settings are not met.
std::unique_ptr<RankSolution> solve(const RankSystem& system, const BlockPreconditioner& preconditioner,
                                    const RankSolverSettings& settings);

} // namespace reference::stokes_fem
