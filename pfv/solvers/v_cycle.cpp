#include "pfv/solvers/v_cycle.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/solvers/coarse_matrix.hpp"

#include <fmt/format.h>

namespace pfv {
namespace {

constexpr int coarsest_rows = 100;

/// Single precision has a narrow range. The largest entry is on the diagonal, if the matrix is positive definite.
double scale_of(const FlowMatrix& matrix) {
  const auto values = Eigen::Map<const Eigen::VectorXd>(matrix.valuePtr(), matrix.nonZeros());
  const double most = values.size() > 0 ? values.maxCoeff() : 0;
  if (!(most > 0))
    throw SolveError(fmt::format("multigrid: the matrix is not positive definite, its largest entry is {}", most));
  return 1 / most;
}

Eigen::VectorXf inverse_diagonal(const FlowMatrix& matrix, double scale) {
  return (scale * matrix.diagonal()).cwiseInverse().cast<float>();
}

/// The level below one, of which `matrix` is the matrix. None when no unknown has a neighbour.
template <class Value>
std::optional<CoarseLevel> coarser_level(MultigridLevel& level, Interpolation from_coarser,
                                         const MatrixView<Value>& matrix, double scale, const GramTerm* term) {
  if (from_coarser.coarse_rows == 0)
    return std::nullopt;
  CoarseLevel coarser(
      coarse_matrix(matrix, from_coarser, scale, term != nullptr ? coarse_term(*term, from_coarser) : GramTerm{}));
  level.from_coarser = std::move(from_coarser.parents);
  return coarser;
}

} // namespace

void VCycle::factor(const FlowMatrix& matrix) {
  coarser_.clear();
  const FlowMatrix& top = with_term(matrix);
  scale_ = scale_of(top);
  finest_.emplace(view(top), scale_);
  if (finest_->rows() <= coarsest_rows)
    return;
  // The interpolation does not know of the term. The first coarse matrix is summed from double precision: in wide
  // throats nearly all of it cancels.
  Interpolation first = &top == &matrix ? interpolation(finest_->matrix(), finest_->inverse_diagonal())
                                        : interpolation(finest_->matrix(), inverse_diagonal(matrix, scale_));
  std::optional<CoarseLevel> next = coarser_level(*finest_, std::move(first), view(matrix), scale_, term_);
  while (next) {
    coarser_.push_back(std::move(*next));
    next.reset();
    if (CoarseLevel& last = coarser_.back(); last.rows() > coarsest_rows)
      next =
          coarser_level(last, interpolation(last.matrix(), last.inverse_diagonal()), view(last.matrix()), 1, nullptr);
  }
  if (coarser_.empty())
    return;
  const SparseRows& coarsest = coarser_.back().matrix();
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(coarsest.rows(), coarsest.rows());
  for (int i = 0; i < coarsest.rows(); ++i)
    for (int e = coarsest.start[i]; e < coarsest.start[i + 1]; ++e)
      dense(i, coarsest.column[e]) = coarsest.value[e];
  coarsest_.compute(dense);
}

void VCycle::follow(const FlowMatrix& matrix) {
  finest_->follow(view(with_term(matrix)), scale_);
}

double VCycle::apply(const Eigen::VectorXd& residual, Eigen::VectorXd& correction) {
  const double size = residual.lpNorm<Eigen::Infinity>();
  finest_->right_side = ((size > 0 ? 1 / size : 0) * residual).cast<float>();
  cycle();
  correction = scale_ * size * finest_->pressure.cast<double>();
  return residual.dot(correction);
}

void VCycle::describe(SolverReport& report) const {
  std::size_t entries = report.matrix_entries;
  report.memory_bytes = finest_->memory_bytes();
  for (const CoarseLevel& level : coarser_) {
    entries += level.matrix().column.size();
    report.memory_bytes += level.memory_bytes() + level.matrix().memory_bytes();
  }
  report.operator_complexity = static_cast<double>(entries) / static_cast<double>(report.matrix_entries);
}

/// The finest level has of the term its diagonal alone, which keeps its rows short: what the term does beyond is
/// smooth, and the coarser levels have it.
const FlowMatrix& VCycle::with_term(const FlowMatrix& matrix) {
  if (term_ == nullptr || term_->empty())
    return matrix;
  with_diagonal_ = matrix;
  with_diagonal_.diagonal() += diagonal(*term_);
  return with_diagonal_;
}

void VCycle::cycle() {
  cycle(*finest_, 0);
}

template <class Level>
void VCycle::cycle(Level& level, std::size_t depth) {
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

void VCycle::solve_coarsest() {
  CoarseLevel& level = coarser_.back();
  level.pressure = coarsest_.solve(level.right_side.cast<double>()).cast<float>();
}

} // namespace pfv
