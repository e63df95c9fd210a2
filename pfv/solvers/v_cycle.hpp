#pragma once

#include "pfv/solvers/coarse_level.hpp"
#include "pfv/solvers/finest_level.hpp"
#include "pfv/solvers/gram_term.hpp"
#include "pfv/solvers/preconditioner.hpp"

#include <Eigen/Cholesky>
#include <optional>
#include <vector>

namespace pfv {

/// One V-cycle of multigrid, in single precision, of a matrix, or of a matrix and a term, which outlives its use and
/// may change with the matrix. Measured on pores between grains that move, ten and a hundred times the explicit limit:
/// half of the iterations that the V-cycle of the matrix alone takes, each for a fourth more.
class VCycle : public Preconditioner {
public:
  explicit VCycle(const GramTerm* term = nullptr) : term_(term) {}

  void factor(const FlowMatrix& matrix) override;
  void follow(const FlowMatrix& matrix) override;
  double apply(const Eigen::VectorXd& residual, Eigen::VectorXd& correction) override;
  void describe(SolverReport& report) const override;

protected:
  /// pressure of the finest level = M right_side.
  void cycle();

  FinestLevel& finest() { return *finest_; }
  double scale() const { return scale_; } // A of the finest level / matrix

private:
  const FlowMatrix& with_term(const FlowMatrix& matrix);
  template <class Level>
  void cycle(Level& level, std::size_t depth);
  void solve_coarsest();

  const GramTerm* term_;
  FlowMatrix with_diagonal_;
  double scale_ = 1;
  std::optional<FinestLevel> finest_;
  std::vector<CoarseLevel> coarser_; // from fine to coarse
  Eigen::LDLT<Eigen::MatrixXd> coarsest_;
};

} // namespace pfv
