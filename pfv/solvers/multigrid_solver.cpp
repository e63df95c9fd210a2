#include "pfv/solvers/multigrid_solver.hpp"

#include "pfv/solvers/conjugate_gradients.hpp"
#include "pfv/solvers/v_cycle.hpp"

#include <algorithm>

namespace pfv {
namespace {

/// Conjugate gradients on the finest level of the V-cycle itself. Its pressures and powers are in units of their own:
/// A of `scale` times the matrix, residuals of the size of the right side.
class SinglePrecisionSteps final : public VCycle {
public:
  void factor(const FlowMatrix& matrix) override {
    VCycle::factor(matrix);
    matrix_ = &matrix;
    residual_.resize(matrix.rows());
    direction_.resize(matrix.rows());
  }

  void follow(const FlowMatrix& matrix) override {
    VCycle::follow(matrix);
    matrix_ = &matrix;
  }

  void describe(SolverReport& report) const override {
    VCycle::describe(report);
    report.memory_bytes += 2 * sizeof(float) * report.unknowns;
  }

  Descent descend(const Eigen::VectorXd& right_side, Eigen::VectorXd& pressure, double tolerance,
                  int most_steps) override {
    Descent descent;
    double power = start(right_side, pressure);
    const double unit = scale() * size_ * size_; // of powers
    double old_error = 1, error_when_fresh = 0;
    bool is_fresh = true; // the residual
    direction_.setZero();
    most_steps = std::min(most_steps, most_single_steps);
    while (descent.steps < most_steps && !descent.is_close) {
      const double error = correct();
      direction_ = finest().pressure + static_cast<float>(error / old_error) * direction_;
      const double curvature = finest().multiply(direction_);
      const bool has_stalled = is_fresh && descent.steps > 0 && !(error < error_when_fresh);
      if (has_stalled || !(error > 0 && curvature > 0))
        break;
      const double length = error / curvature;
      advance(length, pressure);
      ++descent.steps;
      power += length * unit * error;

      // Only of a fresh residual is the error what it says, so the one of what may be the last step has to be.
      const double bound = tolerance * tolerance * power;
      descent.is_close = is_fresh && unit * error <= bound;
      error_when_fresh = is_fresh ? error : error_when_fresh;
      const double next_error = error * std::min(error / old_error, 1.0);
      is_fresh = error <= reliable * reliable * error_when_fresh || unit * next_error <= nearly * bound;
      if (is_fresh && !descent.is_close)
        refresh(right_side, pressure);
      old_error = error;
    }
    return descent;
  }

private:
  static constexpr int most_single_steps = 100;
  static constexpr double reliable = 1e-5; // of the error left: residuals are taken anew
  static constexpr double nearly = 3;      // times the bound, as the next error is a guess

  /// Drops a guess that is worse than none. Sets size and residual; returns the power of the pressure less that of its
  /// error.
  double start(const Eigen::VectorXd& right_side, Eigen::VectorXd& pressure) {
    size_ = right_side.lpNorm<Eigen::Infinity>();
    const double power = refresh(right_side, pressure);
    if (power > 0)
      return power;
    pressure.setZero();
    return refresh(right_side, pressure);
  }

  /// residual = (b - A p) / size; returns p.(b + residual).
  double refresh(const Eigen::VectorXd& right_side, const Eigen::VectorXd& pressure) {
    const int* start = matrix_->outerIndexPtr();
    const int* column = matrix_->innerIndexPtr();
    const double* value = matrix_->valuePtr();
    const double into = 1 / size_;
    double power = 0;
    for (Eigen::Index i = 0; i < right_side.size(); ++i) {
      double rest = right_side[i];
      for (int e = start[i]; e < start[i + 1]; ++e)
        rest -= value[e] * pressure[column[e]];
      residual_[i] = static_cast<float>(into * rest);
      power += pressure[i] * (right_side[i] + rest);
    }
    return power;
  }

  /// pressure of the finest level = M residual; returns their scalar product.
  double correct() {
    finest().right_side = residual_;
    cycle();
    return residual_.cast<double>().dot(finest().pressure.cast<double>());
  }

  void advance(double length, Eigen::VectorXd& pressure) {
    pressure += scale() * size_ * length * direction_.cast<double>();
    residual_ -= static_cast<float>(length) * finest().product();
  }

  const FlowMatrix* matrix_ = nullptr;
  double size_ = 0; // of the right side, unit of residuals
  Eigen::VectorXf residual_, direction_;
};

} // namespace

std::unique_ptr<FlowSolver> make_multigrid(const Multigrid& parameters) {
  return make_conjugate_gradients("multigrid", std::make_unique<SinglePrecisionSteps>(), parameters.tolerance);
}

} // namespace pfv
