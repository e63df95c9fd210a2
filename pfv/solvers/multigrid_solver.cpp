#include "pfv/solvers/multigrid_solver.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/solvers/coarse_matrix.hpp"
#include "pfv/solvers/conjugate_gradients.hpp"
#include "pfv/solvers/multigrid_level.hpp"

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include <optional>
#include <vector>

namespace pfv {
namespace {

class VCycle final : public Preconditioner {
public:
  explicit VCycle(const GramTerm* term = nullptr) : term_(term) {}

  void factor(const FlowMatrix& matrix) override {
    coarser_.clear();
    coarse_matrices_.clear();
    const FlowMatrix& top = finest(matrix);
    scale_ = scale_of(top);
    finest_.emplace(view(top), scale_);
    // The first coarse matrix is summed from double precision: in wide throats nearly all of it cancels.
    bool has_coarser = finest_->rows() > coarsest_rows && coarsen(view(matrix), scale_, *finest_, term_);
    while (has_coarser && coarser_.back().rows() > coarsest_rows)
      has_coarser = coarsen(view(coarse_matrices_.back()), 1, coarser_.back());
    if (!coarser_.empty())
      factor_coarsest();
  }

  void follow(const FlowMatrix& matrix) override { finest_->follow(view(finest(matrix)), scale_); }

  double apply(const Eigen::VectorXd& residual, Eigen::VectorXd& correction) override {
    const double size = residual.lpNorm<Eigen::Infinity>();
    const double into = size > 0 ? 1 / size : 0, back = scale_ * size;
    for (int i = 0; i < finest_->rows(); ++i)
      finest_->right_side[i] = static_cast<float>(into * residual[i]);
    cycle(*finest_, 0);
    double product = 0;
    for (int i = 0; i < finest_->rows(); ++i) {
      correction[i] = back * finest_->pressure[i];
      product += residual[i] * correction[i];
    }
    return product;
  }

  void describe(SolverReport& report) const override {
    std::size_t entries = report.matrix_entries;
    report.memory_bytes = finest_->memory_bytes();
    for (const SparseRows& matrix : coarse_matrices_) {
      entries += matrix.column.size();
      report.memory_bytes += matrix.memory_bytes();
    }
    for (const auto& level : coarser_)
      report.memory_bytes += level.memory_bytes();
    report.operator_complexity = static_cast<double>(entries) / static_cast<double>(report.matrix_entries);
  }

private:
  static constexpr int coarsest_rows = 100;

  /// Single precision has a narrow range.
  static double scale_of(const FlowMatrix& matrix) {
    const Eigen::VectorXd diagonal = matrix.diagonal();
    if (!(diagonal.minCoeff() > 0))
      throw SolveError(
          fmt::format("multigrid: the matrix is not positive definite, {} on its diagonal", diagonal.minCoeff()));
    return 1 / diagonal.maxCoeff();
  }

  /// The finest level has of the term its diagonal alone, which keeps its rows short: what the term does beyond is
  /// smooth, and the coarser levels have it.
  const FlowMatrix& finest(const FlowMatrix& matrix) {
    const FlowMatrix* finest = &matrix;
    if (term_ != nullptr && !term_->empty()) {
      with_diagonal_ = matrix;
      with_diagonal_.diagonal() += diagonal(*term_);
      finest = &with_diagonal_;
    }
    return *finest;
  }

  /// Adds the level below the last one, which is that of the matrix. Whether there is one.
  template <class Value>
  bool coarsen(const MatrixView<Value>& fine, double scale, MultigridLevel<Value>& level,
               const GramTerm* term = nullptr) {
    Interpolation from_coarser = interpolation(fine);
    if (from_coarser.coarse_rows == 0)
      return false;
    SparseRows coarse =
        coarse_matrix(fine, from_coarser, scale, term != nullptr ? coarse_term(*term, from_coarser) : GramTerm{});
    level.from_coarser = std::move(from_coarser.parents);
    coarse_matrices_.push_back(std::move(coarse));
    coarser_.emplace_back(view(coarse_matrices_.back()), 1);
    return true;
  }

  void factor_coarsest() {
    const SparseRows& coarsest = coarse_matrices_.back();
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(coarsest.rows(), coarsest.rows());
    for (int i = 0; i < coarsest.rows(); ++i)
      for (int e = coarsest.start[i]; e < coarsest.start[i + 1]; ++e)
        dense(i, coarsest.column[e]) = coarsest.value[e];
    coarsest_.compute(dense);
  }

  void solve_coarsest() {
    MultigridVectors& level = coarser_.back();
    const auto rows = static_cast<Eigen::Index>(level.pressure.size());
    const auto right_side = Eigen::Map<const Eigen::VectorXf>(level.right_side.data(), rows);
    Eigen::Map<Eigen::VectorXf>(level.pressure.data(), rows) = coarsest_.solve(right_side.cast<double>()).cast<float>();
  }

  template <class Value>
  void cycle(MultigridLevel<Value>& level, std::size_t depth) {
    level.sweep_up_from_zero();
    if (depth < coarser_.size()) {
      level.restrict_residual_to(coarser_[depth]);
      if (depth + 1 == coarser_.size())
        solve_coarsest();
      else
        cycle(coarser_[depth], depth + 1);
      level.take_correction_of(coarser_[depth]);
    } else {
      level.take_no_correction();
    }
    level.sweep_down();
  }

  const GramTerm* term_;
  FlowMatrix with_diagonal_;
  double scale_ = 1;
  std::optional<MultigridLevel<double>> finest_;
  std::vector<MultigridLevel<float>> coarser_; // from fine to coarse
  std::vector<SparseRows> coarse_matrices_;    // theirs
  Eigen::LDLT<Eigen::MatrixXd> coarsest_;
};

} // namespace

std::unique_ptr<FlowSolver> make_multigrid(const Multigrid& parameters) {
  return make_conjugate_gradients("multigrid", std::make_unique<VCycle>(), parameters.tolerance);
}

std::unique_ptr<Preconditioner> make_v_cycle(const GramTerm* term) {
  return std::make_unique<VCycle>(term);
}

} // namespace pfv
