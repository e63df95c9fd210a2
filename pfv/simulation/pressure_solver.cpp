#include "pfv/simulation/pressure_solver.hpp"

#include "pfv/problem/error.hpp"

#include <cmath>
#include <fmt/format.h>

namespace pfv {

int PressureSolver::solve(const FlowMatrix& matrix, const GramTerm& term, Preconditioner& preconditioner,
                          const Eigen::VectorXd& right_side, double tolerance, Eigen::VectorXd& x,
                          PastIncrements* past) {
  constexpr int most_steps = 2000;
  if (right_side.size() == 0)
    return 0;
  if (right_side.isZero(0)) {
    x.setZero();
    return 0;
  }
  multiply(matrix, term, x, of_block_, image_);
  residual_ = right_side - image_;
  if (past != nullptr) {
    first_x_ = x;
    first_residual_ = residual_;
    past->improve(x, residual_);
  }
  correction_.resize(x.size());
  direction_.setZero(x.size());
  double before = 1;
  for (int n = 0; n < most_steps; ++n) {
    const double power = preconditioner.apply(residual_, correction_);
    if (!std::isfinite(power))
      throw SolveError("the pressure of the pores is not finite");
    if (power <= tolerance * tolerance * std::abs(x.dot(right_side))) {
      if (past != nullptr)
        past->add(x - first_x_, first_residual_ - residual_);
      return n;
    }
    direction_ = correction_ + power / before * direction_;
    before = power;
    const double length = power / multiply(matrix, term, direction_, of_block_, image_);
    x += length * direction_;
    residual_ -= length * image_;
  }
  throw SolveError(
      fmt::format("the pressures of the pores did not settle to {:.0e} in {} steps", tolerance, most_steps));
}

} // namespace pfv
