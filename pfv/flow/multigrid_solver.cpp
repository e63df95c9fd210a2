#include "pfv/flow/multigrid_solver.hpp"

#include "pfv/flow/coarse_matrix.hpp"
#include "pfv/flow/conjugate_gradients.hpp"
#include "pfv/flow/multigrid_level.hpp"
#include "pfv/problem/error.hpp"

#include <Eigen/Cholesky>
#include <fmt/format.h>

namespace pfv {
namespace {

class VCycle final : public Preconditioner {
public:
  void factor(const FlowMatrix& matrix) override {
    const Eigen::VectorXd diagonal = matrix.diagonal();
    if (!(diagonal.minCoeff() > 0))
      throw SolveError(
          fmt::format("multigrid: the matrix is not positive definite, {} on its diagonal", diagonal.minCoeff()));
    scale_ = 1 / diagonal.maxCoeff(); // single precision has a narrow range
    levels_.clear();
    levels_.emplace_back(view(matrix), scale_);
    // The first coarse matrix is summed from double precision: in wide throats nearly all of it cancels.
    SparseRows coarsest = coarsen(view(matrix), scale_);
    while (has_coarser_ && levels_.back().rows() > coarsest_rows) {
      SparseRows coarser = coarsen(view(coarsest), 1);
      if (has_coarser_)
        coarsest = std::move(coarser);
    }
    if (has_coarser_)
      factor(coarsest);
  }

  double apply(const Eigen::VectorXd& residual, Eigen::VectorXd& correction) override {
    MultigridLevel& finest = levels_.front();
    const double size = residual.lpNorm<Eigen::Infinity>();
    const double into = size > 0 ? 1 / size : 0, back = scale_ * size;
    for (int i = 0; i < finest.rows(); ++i)
      finest.right_side[i] = static_cast<float>(into * residual[i]);
    cycle(0);
    double product = 0;
    for (int i = 0; i < finest.rows(); ++i) {
      correction[i] = back * finest.pressure[i];
      product += residual[i] * correction[i];
    }
    return product;
  }

  void describe(SolverReport& report) const override {
    std::size_t entries = 0;
    report.memory_bytes = 0;
    for (const MultigridLevel& level : levels_) {
      entries += level.entries();
      report.memory_bytes += level.memory_bytes();
    }
    report.operator_complexity = static_cast<double>(entries) / static_cast<double>(levels_.front().entries());
  }

private:
  static constexpr int coarsest_rows = 100;

  /// Adds the level below the last one, whose matrix is `fine`, and returns its matrix.
  template <class Value>
  SparseRows coarsen(const MatrixView<Value>& fine, double scale) {
    Interpolation from_coarser = interpolation(fine);
    has_coarser_ = from_coarser.coarse_rows > 0;
    if (!has_coarser_)
      return {};
    SparseRows coarse = coarse_matrix(fine, from_coarser, scale);
    levels_.back().from_coarser = std::move(from_coarser.parents);
    levels_.emplace_back(view(coarse), 1);
    return coarse;
  }

  void factor(const SparseRows& coarsest) {
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(coarsest.rows(), coarsest.rows());
    for (int i = 0; i < coarsest.rows(); ++i)
      for (int e = coarsest.start[i]; e < coarsest.start[i + 1]; ++e)
        dense(i, coarsest.column[e]) = coarsest.value[e];
    coarsest_.compute(dense);
  }

  void cycle(std::size_t depth) {
    MultigridLevel& level = levels_[depth];
    if (has_coarser_ && depth + 1 == levels_.size()) {
      const auto right_side = Eigen::Map<const Eigen::VectorXf>(level.right_side.data(), level.rows());
      Eigen::Map<Eigen::VectorXf>(level.pressure.data(), level.rows()) =
          coarsest_.solve(right_side.cast<double>()).cast<float>();
      return;
    }
    level.sweep_up_from_zero();
    if (depth + 1 < levels_.size()) {
      level.restrict_residual_to(levels_[depth + 1]);
      cycle(depth + 1);
      level.add_correction_of(levels_[depth + 1]);
    }
    level.sweep_down();
  }

  double scale_ = 1;
  std::vector<MultigridLevel> levels_; // from fine to coarse
  bool has_coarser_ = false;
  Eigen::LDLT<Eigen::MatrixXd> coarsest_;
};

} // namespace

std::unique_ptr<FlowSolver> make_multigrid(const Multigrid& parameters) {
  return make_conjugate_gradients("multigrid", std::make_unique<VCycle>(), parameters.tolerance);
}

} // namespace pfv
