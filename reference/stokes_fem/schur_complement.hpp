#pragma once

#include "reference/stokes_fem/cholesky.hpp"
#include "reference/stokes_fem/velocity_component.hpp"

#include <vector>

namespace reference::stokes_fem {

using Velocity = std::array<Eigen::VectorXd, 3>; // free unknowns, by component

/// S = B A^-1 B^T, pressure to divergence, A^-1 by Cholesky factors of the three components' Laplacians. Keeps a
/// reference to the components.
class SchurComplement {
public:
  explicit SchurComplement(const VelocityComponents& components);

  /// A^-1 (load of the pressure faces).
  Velocity driven() const;
  /// A^-1 B^T pressure.
  Velocity response(const Eigen::VectorXd& pressure) const;
  /// B velocity.
  Eigen::VectorXd divergence(const Velocity& velocity) const;
  double factor_entries() const;

private:
  const VelocityComponents& components_;
  std::vector<Cholesky> factors_;
};

/// P^-1 = L^-1 (B D^-1 A D^-1 B^T) L^-1, L = B D^-1 B^T, D = diag A: least-squares commutator (scaled BFBt) of Elman,
/// Howle, Shadid, Shuttleworth, Tuminaro 2006, SIAM J. Sci. Comput. 27, 1651. Keeps a reference to the components.
class CommutatorPreconditioner {
public:
  explicit CommutatorPreconditioner(const VelocityComponents& components);

  Eigen::VectorXd operator()(const Eigen::VectorXd& residual) const;
  double factor_entries() const { return laplace_.entries(); }

private:
  const VelocityComponents& components_;
  std::array<Eigen::VectorXd, 3> inverse_diagonal_;
  Cholesky laplace_;
};

} // namespace reference::stokes_fem
