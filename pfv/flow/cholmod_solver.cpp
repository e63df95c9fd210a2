#include "pfv/flow/cholmod_solver.hpp"

#include "pfv/problem/error.hpp"

#include <Eigen/CholmodSupport>

namespace pfv {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

class CholmodSolver final : public FlowSolver {
public:
  CholmodSolver() {
    report_.name = "cholmod";
    factor_.cholmod().print = 0;
    factor_.cholmod().final_asis = 0; // else small matrices get an L D L', which takes indefinite ones too
    factor_.cholmod().final_ll = 1;
  }

  void factor(const Matrix& lower) override {
    matrix_ = lower;
    if (matrix_.rows() == 0)
      return;
    factor_.compute(matrix_);
    if (factor_.info() != Eigen::Success)
      throw SolveError("cholmod: the matrix is not positive definite");
    report_.factor_entries = static_cast<std::size_t>(factor_.cholmod().lnz);
  }

  /// One step of refinement brings the balance of fluxes to round-off.
  Eigen::VectorXd solve(const Eigen::VectorXd& right_side) override {
    if (right_side.size() == 0)
      return right_side;
    const auto symmetric = matrix_.selfadjointView<Eigen::Lower>();
    Eigen::VectorXd solution = factor_.solve(right_side);
    Eigen::VectorXd residual = right_side - symmetric * solution;
    solution += factor_.solve(residual);
    residual = right_side - symmetric * solution;
    report_.iterations = 1;
    const double scale = right_side.norm();
    report_.residual = scale > 0 ? residual.norm() / scale : 0;
    return solution;
  }

private:
  Matrix matrix_;
  Eigen::CholmodDecomposition<Matrix, Eigen::Lower> factor_;
};

} // namespace

std::unique_ptr<FlowSolver> make_cholmod() {
  return std::make_unique<CholmodSolver>();
}

} // namespace pfv
