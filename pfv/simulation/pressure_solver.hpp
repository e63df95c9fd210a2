#pragma once

#include "pfv/simulation/past_increments.hpp"
#include "pfv/solvers/gram_term.hpp"
#include "pfv/solvers/preconditioner.hpp"

namespace pfv {

/// (A + S) x = b, step after step, by conjugate gradients from the last solution, preconditioned by a V-cycle. Nothing
/// is allocated from the second solution on.
class PressureSolver {
public:
  /// The matrix and the term outlive their use and stay as they are.
  void set(const FlowMatrix& matrix, const GramTerm& term);

  /// Until the error in the norm of the matrix is below tolerance^2 x.b. It is r.M r before a step, M the
  /// preconditioner; after it, estimated by how much r.D^-1 r has changed, D the diagonal, which is right within a
  /// tenth and saves a V-cycle. Returns the iterations. Throws SolveError.
  int solve(const Eigen::VectorXd& right_side, double tolerance, Eigen::VectorXd& x, PastIncrements* past = nullptr);

  /// K has changed since these increments.
  void renew(PastIncrements& past) {
    past.renew([this](const Eigen::VectorXd& x, Eigen::VectorXd& y) { multiply(*matrix_, *term_, x, of_block_, y); });
  }

private:
  double advance(double length, Eigen::VectorXd& x);

  const FlowMatrix* matrix_ = nullptr;
  const GramTerm* term_ = nullptr;
  std::unique_ptr<Preconditioner> preconditioner_;
  Eigen::VectorXd inverse_diagonal_;
  Eigen::VectorXd residual_, direction_, correction_, image_;
  std::vector<Vec3> of_block_;
};

} // namespace pfv
