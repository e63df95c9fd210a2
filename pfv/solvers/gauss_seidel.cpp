#include "pfv/solvers/gauss_seidel.hpp"

#include "pfv/problem/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace pfv {
namespace {

class GaussSeidelSolver final : public FlowSolver {
public:
  explicit GaussSeidelSolver(const GaussSeidel& parameters) : parameters_(parameters) {
    if (parameters.relaxation && !(*parameters.relaxation > 0 && *parameters.relaxation < 2))
      throw InputError(fmt::format("relaxation {} must lie between 0 and 2", *parameters.relaxation));
    report_.name = "gauss-seidel";
  }

  void analyse(const FlowMatrix& matrix) override {
    report_.unknowns = static_cast<std::size_t>(matrix.rows());
    report_.matrix_entries = static_cast<std::size_t>(matrix.nonZeros());
  }

  void factor(const FlowMatrix& matrix) override {
    if (matrix.rows() > 0 && !(matrix.diagonal().minCoeff() > 0))
      throw SolveError("gauss-seidel: the matrix is not positive definite, its diagonal is not positive");
    matrix_ = &matrix;
  }

  void update(const FlowMatrix& matrix) override { factor(matrix); }

  void solve(const Eigen::VectorXd& right_side, Eigen::VectorXd& pressure) override {
    if (pressure.size() != right_side.size())
      pressure.setZero(right_side.size());
    const double scale = right_side.norm();
    report_.iterations = 0;
    report_.residual = 0;
    if (!std::isfinite(scale))
      throw SolveError("gauss-seidel: the right side is not finite");
    if (scale == 0) {
      pressure.setZero();
      return;
    }
    constexpr int sweeps_between_checks = 20;
    double relaxation = parameters_.relaxation.value_or(1.9);
    double decay = 0;
    do {
      if (report_.iterations >= parameters_.largest_sweeps)
        throw SolveError(fmt::format("gauss-seidel: residual {:.1e} after {} sweeps, {:.1e} asked for",
                                     report_.residual, report_.iterations, parameters_.tolerance));
      const double first = sweep(right_side, relaxation, pressure);
      double last = first;
      for (int s = 1; s < sweeps_between_checks; ++s)
        last = sweep(right_side, relaxation, pressure);
      const double previous_decay = decay;
      decay = first > 0 ? std::pow(last / first, 1.0 / (sweeps_between_checks - 1)) : 0;
      report_.iterations += sweeps_between_checks;
      report_.relaxation = relaxation;
      const bool settled = std::abs(decay - previous_decay) < 0.1 * (1 - decay);
      if (!parameters_.relaxation && settled)
        relaxation = adapted(relaxation, decay);
      report_.residual = (right_side - *matrix_ * pressure).norm() / scale;
      if (!std::isfinite(report_.residual))
        throw SolveError("gauss-seidel: it diverges, the matrix is not positive definite");
    } while (!(report_.residual <= parameters_.tolerance));
  }

  const SolverReport& report() const override { return report_; }

private:
  /// One pass over the pores; the norm of the change it makes.
  double sweep(const Eigen::VectorXd& right_side, double relaxation, Eigen::VectorXd& solution) const {
    double change = 0;
    for (Eigen::Index i = 0; i < matrix_->rows(); ++i) {
      double balance = right_side[i], diagonal = 0;
      for (FlowMatrix::InnerIterator entry(*matrix_, i); entry; ++entry) {
        if (entry.col() == i)
          diagonal = entry.value();
        else
          balance -= entry.value() * solution[entry.col()];
      }
      const double step = relaxation * (balance / diagonal - solution[i]);
      solution[i] += step;
      change += step * step;
    }
    return std::sqrt(change);
  }

  /// Raises the relaxation only: a decay at or below w - 1 means that w is at its optimum or past it.
  static double adapted(double relaxation, double decay) {
    if (!(decay > relaxation - 1 && decay < 1))
      return relaxation;
    const double rho = (decay + relaxation - 1) / (relaxation * std::sqrt(decay));
    if (rho >= 1)
      return relaxation;
    const double best = 2 / (1 + std::sqrt(1 - rho * rho));
    return std::clamp(best, relaxation, 1.999);
  }

  GaussSeidel parameters_;
  const FlowMatrix* matrix_ = nullptr;
  SolverReport report_;
};

} // namespace

std::unique_ptr<FlowSolver> make_gauss_seidel(const GaussSeidel& parameters) {
  return std::make_unique<GaussSeidelSolver>(parameters);
}

} // namespace pfv
