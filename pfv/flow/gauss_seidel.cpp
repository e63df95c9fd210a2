#include "pfv/flow/gauss_seidel.hpp"

#include "pfv/problem/error.hpp"

#include <fmt/format.h>

namespace pfv {
namespace {

class GaussSeidelSolver final : public FlowSolver {
public:
  explicit GaussSeidelSolver(const GaussSeidel& parameters) : parameters_(parameters) {
    if (!(parameters.relaxation > 0 && parameters.relaxation < 2))
      throw InputError(fmt::format("relaxation {} must lie between 0 and 2", parameters.relaxation));
    report_.name = "gauss-seidel";
  }

  void factor(const Eigen::SparseMatrix<double>& lower) override { rows_ = lower.selfadjointView<Eigen::Lower>(); }

  Eigen::VectorXd solve(const Eigen::VectorXd& right_side) override {
    Eigen::VectorXd solution = Eigen::VectorXd::Zero(right_side.size());
    const double scale = right_side.norm();
    report_.iterations = 0;
    report_.residual = 0;
    if (scale == 0)
      return solution;
    constexpr int sweeps_between_checks = 10;
    do {
      if (report_.iterations >= parameters_.largest_sweeps)
        throw SolveError(fmt::format("gauss-seidel: residual {:.1e} after {} sweeps, {:.1e} asked for", report_.residual,
                                     report_.iterations, parameters_.tolerance));
      for (int s = 0; s < sweeps_between_checks; ++s)
        sweep(right_side, solution);
      report_.iterations += sweeps_between_checks;
      report_.residual = (right_side - rows_ * solution).norm() / scale;
    } while (!(report_.residual <= parameters_.tolerance));
    return solution;
  }

private:
  void sweep(const Eigen::VectorXd& right_side, Eigen::VectorXd& solution) const {
    for (Eigen::Index i = 0; i < rows_.outerSize(); ++i) {
      double balance = right_side[i], diagonal = 0;
      for (Rows::InnerIterator entry(rows_, i); entry; ++entry) {
        if (entry.col() == i)
          diagonal = entry.value();
        else
          balance -= entry.value() * solution[entry.col()];
      }
      solution[i] += parameters_.relaxation * (balance / diagonal - solution[i]);
    }
  }

  using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  GaussSeidel parameters_;
  Rows rows_;
};

} // namespace

std::unique_ptr<FlowSolver> make_gauss_seidel(const GaussSeidel& parameters) {
  return std::make_unique<GaussSeidelSolver>(parameters);
}

} // namespace pfv
