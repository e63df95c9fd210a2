#pragma once

#include "reference/stokes_fem/node_laplacian.hpp"

#include <memory>

namespace reference::stokes_fem {

/// Solves the three velocity Laplacians, A u = load.
class VelocitySolver {
public:
  virtual ~VelocitySolver() = default;

  /// To a residual of `tolerance` times the load's norm; exact solvers do better. Throws pfv::SolveError when it gets
  /// nowhere.
  virtual Velocity solve(const Velocity& load, double tolerance) const = 0;
  /// Nonzeros of Cholesky factors.
  virtual double factor_entries() const { return 0; }
  /// Iterations of all solves so far.
  virtual int iterations() const { return 0; }
};

/// Cholesky factors of the three matrices. Throws pfv::SolveError when one cannot be factored.
std::unique_ptr<VelocitySolver> make_direct_velocity_solver(const SparseMatrix& lower,
                                                            const VelocityComponents& components);

/// Conjugate gradients on all components at once, preconditioned by VelocityMultigrid. Keeps references to Laplacian
/// and components.
std::unique_ptr<VelocitySolver> make_multigrid_velocity_solver(const NodeLaplacian& laplacian,
                                                               const VelocityComponents& components,
                                                               const std::vector<std::array<int, 2>>& ends);

} // namespace reference::stokes_fem
