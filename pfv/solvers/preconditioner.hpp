#pragma once

#include "pfv/solvers/flow_solver.hpp"

namespace pfv {

/// What a preconditioner does for the answer by itself.
struct Descent {
  int steps = 0;
  bool is_close = false; // to the tolerance
};

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
  /// From a first guess to the answer, as conjugate_gradients.hpp defines it, by means of its own that cost less than
  /// `apply` and the steps of its caller, as far as they lead.
  virtual Descent descend(const Eigen::VectorXd& /*right_side*/, Eigen::VectorXd& /*pressure*/, double /*tolerance*/,
                          int /*most_steps*/) {
    return {};
  }
  /// Fills in factor_entries or operator_complexity, and memory_bytes.
  virtual void describe(SolverReport& report) const = 0;
};

} // namespace pfv
