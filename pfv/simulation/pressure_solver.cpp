#include "pfv/simulation/pressure_solver.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/solvers/v_cycle.hpp"

#include <cmath>
#include <fmt/format.h>

namespace pfv {

void PressureSolver::set(const FlowMatrix& matrix, const GramTerm& term) {
  matrix_ = &matrix;
  term_ = &term;
  if (matrix.rows() == 0)
    return;
  preconditioner_ = std::make_unique<VCycle>(&term);
  preconditioner_->factor(matrix);
  inverse_diagonal_ = matrix.diagonal();
  if (!term.empty())
    inverse_diagonal_ += diagonal(term);
  inverse_diagonal_ = inverse_diagonal_.cwiseInverse();
}

int PressureSolver::solve(const Eigen::VectorXd& right_side, double tolerance, Eigen::VectorXd& x,
                          PastIncrements* past) {
  constexpr int most_steps = 2000;
  if (right_side.isZero(0)) {
    x.setZero();
    return 0;
  }
  multiply(*matrix_, *term_, x, of_block_, image_);
  residual_ = right_side - image_;
  if (past != nullptr)
    past->improve(x, residual_);
  correction_.resize(x.size());
  direction_.setZero(x.size());
  double before = 1, size = residual_.cwiseAbs2().dot(inverse_diagonal_);
  for (int n = 0; n < most_steps; ++n) {
    const double power = preconditioner_->apply(residual_, correction_);
    if (!std::isfinite(power))
      throw SolveError("the pressure of the pores is not finite");
    direction_ = correction_ + power / before * direction_;
    before = power;
    double left = power;
    if (left > tolerance * tolerance * std::abs(x.dot(right_side))) {
      const double length = power / multiply(*matrix_, *term_, direction_, of_block_, image_);
      const double new_size = advance(length, x);
      left *= new_size / size;
      size = new_size;
    }
    if (const double whole = std::abs(x.dot(right_side)); left <= tolerance * tolerance * whole) {
      constexpr double negligible = 1e-2; // of the tolerance
      if (past != nullptr)
        past->remember(x, residual_, std::pow(negligible * tolerance, 2) * whole);
      return n + 1;
    }
  }
  throw SolveError(
      fmt::format("the pressures of the pores did not settle to {:.0e} in {} steps", tolerance, most_steps));
}

/// A step along the direction; returns r.D^-1 r.
double PressureSolver::advance(double length, Eigen::VectorXd& x) {
  double size = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    x[i] += length * direction_[i];
    residual_[i] -= length * image_[i];
    size += residual_[i] * residual_[i] * inverse_diagonal_[i];
  }
  return size;
}

} // namespace pfv
