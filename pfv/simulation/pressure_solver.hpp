#pragma once

#include "pfv/simulation/past_increments.hpp"
#include "pfv/solvers/gram_term.hpp"
#include "pfv/solvers/preconditioner.hpp"

namespace pfv {

/// (A + S) x = b, step after step, by preconditioned conjugate gradients from the last solution. Nothing is allocated
/// from the second solution of a size on.
class PressureSolver {
public:
  /// Throws SolveError when the tolerance, of the error in the norm of the matrix against x.b, is not reached. Returns
  /// the iterations.
  int solve(const FlowMatrix& matrix, const GramTerm& term, Preconditioner& preconditioner,
            const Eigen::VectorXd& right_side, double tolerance, Eigen::VectorXd& x, PastIncrements* past = nullptr);

private:
  Eigen::VectorXd residual_, direction_, correction_, image_;
  Eigen::VectorXd first_x_, first_residual_; // before the first step
  std::vector<Vec3> of_block_;
};

} // namespace pfv
