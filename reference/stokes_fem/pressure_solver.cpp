#include "reference/stokes_fem/pressure_solver.hpp"

#include "pfv/solvers/flow_solver.hpp"
#include "reference/stokes_fem/cholesky.hpp"

namespace reference::stokes_fem {

namespace {

using Eigen::VectorXd;

class DirectPressureSolver final : public PressureSolver {
public:
  explicit DirectPressureSolver(const SparseRows& laplacian)
      : factor_(SparseMatrix(laplacian).triangularView<Eigen::Lower>()) {}

  VectorXd solve(const VectorXd& right_side) const override { return factor_.solve(right_side); }
  double factor_entries() const override { return factor_.entries(); }

private:
  Cholesky factor_;
};

class MultigridPressureSolver final : public PressureSolver {
public:
  explicit MultigridPressureSolver(const SparseRows& laplacian) {
    matrix_ = laplacian;
    solver_->analyse(matrix_);
    solver_->factor(matrix_);
  }

  VectorXd solve(const VectorXd& right_side) const override {
    VectorXd pressure;
    solver_->solve(right_side, pressure);
    return pressure;
  }

private:
  pfv::FlowMatrix matrix_;
  std::unique_ptr<pfv::FlowSolver> solver_ = pfv::make_solver(pfv::Multigrid{.tolerance = 1e-2});
};

} // namespace

std::unique_ptr<PressureSolver> make_direct_pressure_solver(const SparseRows& laplacian) {
  return std::make_unique<DirectPressureSolver>(laplacian);
}

std::unique_ptr<PressureSolver> make_multigrid_pressure_solver(const SparseRows& laplacian) {
  return std::make_unique<MultigridPressureSolver>(laplacian);
}

} // namespace reference::stokes_fem
