#pragma once

#include "pfv/solvers/flow_solver.hpp"

namespace pfv {

/// An approximate inverse M of a FlowMatrix, symmetric positive definite.
class Preconditioner {
public:
  virtual ~Preconditioner() = default;

  /// What depends on the pattern alone.
  virtual void analyse(const FlowMatrix&) {}
  /// Builds M. The matrix outlives its use. Throws SolveError when the matrix is seen not to be positive definite.
  virtual void factor(const FlowMatrix& matrix) = 0;
  /// The matrix has changed a little: M need not, but may only read the new one from here on.
  virtual void follow(const FlowMatrix&) {}
  /// correction = M residual; returns their scalar product.
  virtual double apply(const Eigen::VectorXd& residual, Eigen::VectorXd& correction) = 0;
  /// Fills in factor_entries or operator_complexity, and memory_bytes.
  virtual void describe(SolverReport& report) const = 0;
};

} // namespace pfv
