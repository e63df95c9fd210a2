#pragma once

#include "reference/stokes_fem/stokes_system.hpp"

#include <memory>

namespace reference::stokes_fem {

/// Sparse Cholesky factorisation (CHOLMOD, supernodal, nested dissection).
class Cholesky {
public:
  /// Of the symmetric positive definite matrix whose lower triangle is given. Throws pfv::SolveError when it is not, or
  /// when memory runs out.
  explicit Cholesky(const SparseMatrix& lower);
  ~Cholesky();
  Cholesky(Cholesky&&) noexcept;
  Cholesky& operator=(Cholesky&&) noexcept;

  Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const;
  /// Nonzeros of the factor.
  double entries() const;

private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

} // namespace reference::stokes_fem
