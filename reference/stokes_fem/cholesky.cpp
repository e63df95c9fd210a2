#include "reference/stokes_fem/cholesky.hpp"

#include "pfv/problem/error.hpp"

#include <Eigen/CholmodSupport>

namespace reference::stokes_fem {

struct Cholesky::Factor {
  Eigen::CholmodSupernodalLLT<SparseMatrix, Eigen::Lower> llt;
};

Cholesky::Cholesky(const SparseMatrix& lower) : factor_(std::make_unique<Factor>()) {
  cholmod_common& common = factor_->llt.cholmod();
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_METIS;
  common.print = 0;
  factor_->llt.compute(lower);
  if (factor_->llt.info() == Eigen::Success)
    return;
  const bool memory = common.status == CHOLMOD_OUT_OF_MEMORY || common.status == CHOLMOD_TOO_LARGE;
  throw pfv::SolveError("CHOLMOD cannot factor a matrix of order " + std::to_string(lower.rows()) + ": " +
                        (memory ? "out of memory" : "it is not positive definite"));
}

Cholesky::~Cholesky() = default;
Cholesky::Cholesky(Cholesky&&) noexcept = default;
Cholesky& Cholesky::operator=(Cholesky&&) noexcept = default;

Eigen::VectorXd Cholesky::solve(const Eigen::VectorXd& right_hand_side) const {
  return factor_->llt.solve(right_hand_side);
}

double Cholesky::entries() const {
  return factor_->llt.cholmod().lnz;
}

} // namespace reference::stokes_fem
