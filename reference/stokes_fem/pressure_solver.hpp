#pragma once

#include "reference/stokes_fem/stokes_system.hpp"

#include <memory>

namespace reference::stokes_fem {

/// Solves L p = right side for the symmetric positive definite Laplacian of a preconditioner of the pressure.
class PressureSolver {
public:
  virtual ~PressureSolver() = default;

  virtual Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const = 0;
  /// Nonzeros of a Cholesky factor.
  virtual double factor_entries() const { return 0; }
};

/// By a Cholesky factor. Throws pfv::SolveError when there is none.
std::unique_ptr<PressureSolver> make_direct_pressure_solver(const SparseRows& laplacian);

/// To 1e-2 of the error, by the conjugate gradients with multigrid that solve networks of pores: as good a
/// preconditioner as the exact solution. Throws pfv::SolveError when they do not converge.
std::unique_ptr<PressureSolver> make_multigrid_pressure_solver(const SparseRows& laplacian);

} // namespace reference::stokes_fem
