#include "pfv/solvers/cholmod_solver.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/solvers/conjugate_gradients.hpp"

#include <Eigen/CholmodSupport>

namespace pfv {
namespace {

class CholmodFactor final : public Preconditioner {
public:
  CholmodFactor() {
    factor_.cholmod().print = 0;
    factor_.cholmod().final_asis = 0; // else small matrices get an L D L', which takes indefinite ones too
    factor_.cholmod().final_ll = 1;
  }

  void analyse(const FlowMatrix& matrix) override { factor_.analyzePattern(matrix); }

  void factor(const FlowMatrix& matrix) override {
    factor_.factorize(matrix);
    if (factor_.info() != Eigen::Success)
      throw SolveError("cholmod: the matrix is not positive definite");
  }

  double apply(const Eigen::VectorXd& residual, Eigen::VectorXd& correction) override {
    correction = factor_.solve(residual);
    return residual.dot(correction);
  }

  void describe(SolverReport& report) const override {
    const auto& common = const_cast<Factor&>(factor_).cholmod(); // Eigen offers no const access
    report.factor_entries = static_cast<std::size_t>(common.lnz);
    report.memory_bytes = common.memory_inuse;
  }

private:
  using Factor = Eigen::CholmodDecomposition<FlowMatrix, Eigen::Lower>;
  Factor factor_;
};

} // namespace

std::unique_ptr<FlowSolver> make_cholmod() {
  // Finer than round-off, so that a fresh factor takes its second step: the refinement that balances the fluxes.
  constexpr double tolerance = 1e-9;
  return make_conjugate_gradients("cholmod", std::make_unique<CholmodFactor>(), tolerance);
}

} // namespace pfv
