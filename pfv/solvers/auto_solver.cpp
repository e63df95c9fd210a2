#include "pfv/solvers/auto_solver.hpp"

#include "pfv/problem/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace pfv {
namespace {

constexpr int most_for_a_factor = 300000; // unknowns

/// Milliseconds to set up and to solve once, random packings, one core:
///   unknowns     cholmod      multigrid
///        964     8 + 0.3      0.5 + 0.5
///      11266   132 + 3          5 + 7
///     120626  2230 + 49        87 + 90
/// So a factor pays from some 40 solves, as long as it fits the memory (14 MB per 10^4 unknowns, and growing). Below
/// some hundred unknowns nothing takes time, and the factor gives the last digit.
SolverChoice best_choice(std::size_t unknowns, int solves_per_matrix) {
  constexpr std::size_t few_unknowns = 300;
  constexpr int many_solves = 40;
  const bool reused = solves_per_matrix >= many_solves && unknowns <= static_cast<std::size_t>(most_for_a_factor);
  if (unknowns <= few_unknowns || reused)
    return Cholmod{};
  return Multigrid{};
}

class AutomaticSolver final : public FlowSolver {
public:
  explicit AutomaticSolver(const AutoSolver& parameters) : solves_per_matrix_(parameters.solves_per_matrix) {
    if (solves_per_matrix_ < 1)
      throw InputError(fmt::format("solves_per_matrix {} must be at least 1", solves_per_matrix_));
  }

  void analyse(const FlowMatrix& matrix) override {
    solver_ = make_solver(best_choice(static_cast<std::size_t>(matrix.rows()), solves_per_matrix_));
    solver_->analyse(matrix);
  }
  void factor(const FlowMatrix& matrix) override {
    matrix_ = &matrix;
    solver_->factor(matrix);
  }
  void update(const FlowMatrix& matrix) override {
    matrix_ = &matrix;
    solver_->update(matrix);
  }
  /// Where multigrid gives up, on conductances of many decades, a factor may still answer; the report names it.
  void solve(const Eigen::VectorXd& right_side, Eigen::VectorXd& pressure) override {
    try {
      solver_->solve(right_side, pressure);
    } catch (const SolveError&) {
      if (right_side.size() > most_for_a_factor || solver_->report().name == "cholmod")
        throw;
      solver_ = make_solver(Cholmod{});
      solver_->analyse(*matrix_);
      solver_->factor(*matrix_);
      pressure.resize(0);
      solver_->solve(right_side, pressure);
    }
  }
  const SolverReport& report() const override { return solver_->report(); }

private:
  int solves_per_matrix_;
  const FlowMatrix* matrix_ = nullptr;
  std::unique_ptr<FlowSolver> solver_ = make_solver(Cholmod{});
};

} // namespace

std::unique_ptr<FlowSolver> make_auto_solver(const AutoSolver& parameters) {
  return std::make_unique<AutomaticSolver>(parameters);
}

} // namespace pfv
