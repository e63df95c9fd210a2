#pragma once

#include "reference/stokes_fem/pressure_solver.hpp"
#include "reference/stokes_fem/velocity_solver.hpp"

namespace reference::stokes_fem {

/// B velocity.
Eigen::VectorXd divergence(const VelocityComponents& components, const Velocity& velocity);
/// B^T pressure.
Velocity gradient(const VelocityComponents& components, const Eigen::VectorXd& pressure);

/// P^-1 = L^-1 (B D^-1 A D^-1 B^T) L^-1, L = B D^-1 B^T, D = diag A: least-squares commutator (scaled BFBt) of Elman,
/// Howle, Shadid, Shuttleworth, Tuminaro 2006, SIAM J. Sci. Comput. 27, 1651, for S = B A^-1 B^T. Keeps references.
class CommutatorPreconditioner {
public:
  using MakePressureSolver = std::unique_ptr<PressureSolver> (*)(const SparseRows& laplacian);

  CommutatorPreconditioner(const VelocityComponents& components, const NodeLaplacian& laplacian,
                           const MakePressureSolver& make);

  Eigen::VectorXd operator()(const Eigen::VectorXd& residual) const;
  double factor_entries() const { return laplace_->factor_entries(); }

private:
  const VelocityComponents& components_;
  const NodeLaplacian& laplacian_;
  Velocity inverse_diagonal_;
  std::unique_ptr<PressureSolver> laplace_;
};

} // namespace reference::stokes_fem
