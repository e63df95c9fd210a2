#include "pfv/solvers/conjugate_gradients.hpp"

#include "pfv/problem/error.hpp"

#include <cmath>
#include <fmt/format.h>

namespace pfv {
namespace {

class ConjugateGradients final : public FlowSolver {
public:
  ConjugateGradients(const std::string& name, std::unique_ptr<Preconditioner> preconditioner, double tolerance)
      : preconditioner_(std::move(preconditioner)), tolerance_(tolerance) {
    if (!(tolerance > 0 && tolerance < 1))
      throw InputError(fmt::format("{}: tolerance {} must lie between 0 and 1", name, tolerance));
    report_.name = name;
  }

  void analyse(const FlowMatrix& matrix) override {
    report_.unknowns = static_cast<std::size_t>(matrix.rows());
    report_.matrix_entries = static_cast<std::size_t>(matrix.nonZeros());
    if (matrix.rows() > 0)
      preconditioner_->analyse(matrix);
  }

  void factor(const FlowMatrix& matrix) override {
    matrix_ = &matrix;
    stale_ = false;
    if (matrix.rows() == 0)
      return;
    preconditioner_->factor(matrix);
    describe();
  }

  void update(const FlowMatrix& matrix) override {
    matrix_ = &matrix;
    stale_ = true;
    if (matrix.rows() > 0)
      preconditioner_->follow(matrix);
  }

  void solve(const Eigen::VectorXd& right_side, Eigen::VectorXd& pressure) override {
    if (pressure.size() != right_side.size())
      pressure.setZero(right_side.size());
    report_.iterations = 0;
    report_.residual = 0;
    const double scale = right_side.norm();
    if (!std::isfinite(scale))
      throw SolveError(fmt::format("{}: the right side is not finite", report_.name));
    if (scale == 0) {
      pressure.setZero();
      return;
    }
    if (!approach(right_side, pressure, stale_ ? most_steps_when_stale : most_steps)) {
      if (stale_) {
        factor(*matrix_);
        ++report_.refactored;
      }
      if (!approach(right_side, pressure, most_steps))
        throw SolveError(fmt::format("{}: tolerance {:.1e} not reached in {} iterations", report_.name, tolerance_,
                                     report_.iterations));
    }
    report_.residual = balance(right_side, pressure) / scale;
    if (!std::isfinite(report_.residual))
      throw SolveError(fmt::format("{}: the solution is not finite", report_.name));
    describe();
  }

  const SolverReport& report() const override { return report_; }

private:
  static constexpr int most_steps = 1000;
  static constexpr int most_steps_when_stale = 30;

  void describe() {
    preconditioner_->describe(report_);
    report_.memory_bytes +=
        sizeof(double) * static_cast<std::size_t>(residual_.size() + direction_.size() + product_.size());
  }

  /// False when the steps do not suffice.
  bool approach(const Eigen::VectorXd& right_side, Eigen::VectorXd& pressure, int most) {
    const Descent descent = preconditioner_->descend(right_side, pressure, tolerance_, most);
    report_.iterations += descent.steps;
    return descent.is_close || iterate(right_side, pressure, most);
  }

  /// False when the steps do not suffice. What can be done in one pass over the vectors is, as memory is what it waits
  /// for.
  bool iterate(const Eigen::VectorXd& right_side, Eigen::VectorXd& pressure, int most) {
    residual_ = right_side;
    residual_.noalias() -= *matrix_ * pressure;
    double power = pressure.dot(right_side + residual_); // that of the solution less that of the error
    if (!(power > 0)) {                                  // a guess that is worse than none
      pressure.setZero();
      residual_ = right_side;
      power = 0;
    }
    direction_.setZero(right_side.size());
    product_.resize(right_side.size());
    double old_power_of_error = 1, length = 0;
    bool is_close = false;
    for (int step = 0; step < most && !is_close; ++step) {
      const double power_of_error = preconditioner_->apply(residual_, product_);
      is_close = power_of_error == 0;
      if (is_close)
        break;
      advance_and_turn(length, power_of_error / old_power_of_error, pressure);
      const double curvature = multiply_direction();
      if (!(power_of_error > 0 && curvature > 0))
        throw SolveError(fmt::format("{}: the matrix is not positive definite", report_.name));
      length = power_of_error / curvature;
      residual_ -= length * product_;
      old_power_of_error = power_of_error;
      power += length * power_of_error;
      is_close = power_of_error <= tolerance_ * tolerance_ * power;
      ++report_.iterations;
    }
    pressure += length * direction_;
    return is_close;
  }

  /// Takes the step along the old direction, then sets out for product + keep direction.
  void advance_and_turn(double length, double keep, Eigen::VectorXd& pressure) {
    for (Eigen::Index i = 0; i < pressure.size(); ++i) {
      const double old = direction_[i];
      pressure[i] += length * old;
      direction_[i] = product_[i] + keep * old;
    }
  }

  /// product = A direction; returns direction.product.
  double multiply_direction() {
    const int* start = matrix_->outerIndexPtr();
    const int* column = matrix_->innerIndexPtr();
    const double* value = matrix_->valuePtr();
    double product = 0;
    for (Eigen::Index i = 0; i < product_.size(); ++i) {
      double sum = 0;
      for (int e = start[i]; e < start[i + 1]; ++e)
        sum += value[e] * direction_[column[e]];
      product_[i] = sum;
      product += sum * direction_[i];
    }
    return product;
  }

  /// Shifts all pressures by the one number that makes what is left over sum to zero, so that what enters leaves: the
  /// last step, along the vector of ones, of a descent in the power of the error. Returns |b - A p|.
  double balance(const Eigen::VectorXd& right_side, Eigen::VectorXd& pressure) {
    const int* start = matrix_->outerIndexPtr();
    const int* column = matrix_->innerIndexPtr();
    const double* value = matrix_->valuePtr();
    double left_over = 0, conductance = 0, squares = 0, mixed = 0, row_squares = 0;
    for (Eigen::Index i = 0; i < pressure.size(); ++i) {
      double rest = right_side[i], row = 0;
      for (int e = start[i]; e < start[i + 1]; ++e) {
        rest -= value[e] * pressure[column[e]];
        row += value[e];
      }
      left_over += rest;
      conductance += row;
      squares += rest * rest;
      mixed += rest * row;
      row_squares += row * row;
    }
    const double shift = conductance > 0 ? left_over / conductance : 0;
    pressure.array() += shift;
    return std::sqrt(std::max(0.0, squares - shift * (2 * mixed - shift * row_squares)));
  }

  std::unique_ptr<Preconditioner> preconditioner_;
  double tolerance_;
  const FlowMatrix* matrix_ = nullptr;
  bool stale_ = false;
  Eigen::VectorXd residual_, direction_;
  Eigen::VectorXd product_; // M residual, then A direction
  SolverReport report_;
};

} // namespace

std::unique_ptr<FlowSolver> make_conjugate_gradients(const std::string& name,
                                                     std::unique_ptr<Preconditioner> preconditioner, double tolerance) {
  return std::make_unique<ConjugateGradients>(name, std::move(preconditioner), tolerance);
}

} // namespace pfv
