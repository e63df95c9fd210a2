#pragma once

#include "pfv/solvers/flow_matrix.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace pfv {

/// Over-relaxed Gauss-Seidel, the solver of Catalano et al. 2011, section 5.
struct GaussSeidel {
  std::optional<double> relaxation; // 0 < relaxation < 2; adapted to the matrix when absent
  double tolerance = 1e-12;         // of |b - A p| / |b|
  int largest_sweeps = 200000;
};

/// Cholesky factorisation by CHOLMOD (SuiteSparse).
struct Cholmod {};

/// Conjugate gradients, preconditioned by the classical algebraic multigrid of hypre (BoomerAMG).
struct Amg {
  double tolerance = 1e-10; // of the error in p, in the norm of the dissipated power
};

/// Conjugate gradients, preconditioned by an algebraic multigrid made for networks of pores.
struct Multigrid {
  double tolerance = 1e-10; // of the error in p, in the norm of the dissipated power
};

/// Cholmod or Multigrid, whichever takes less time.
struct AutoSolver {
  int solves_per_matrix = 1;
};

using SolverChoice = std::variant<AutoSolver, Cholmod, GaussSeidel, Amg, Multigrid>;

/// Reads "auto", "cholmod", "gauss-seidel", "amg" or "multigrid". Throws InputError.
SolverChoice solver_named(std::string_view name);

struct SolverReport {
  std::string name;
  std::size_t unknowns = 0;
  std::size_t matrix_entries = 0;
  std::size_t factor_entries = 0; // nonzeros of the Cholesky factor
  double operator_complexity = 0; // entries of all levels of a multigrid / entries of the matrix
  std::size_t memory_bytes = 0;   // held by the engine, the matrix apart: its own arrays, estimated for a library's
  int iterations = 0;             // sweeps, or steps of conjugate gradients, of the last solve
  double residual = 0;            // |b - A p| / |b| of the last solve
  double relaxation = 0;          // last one used, of Gauss-Seidel
  int refactored = 0;             // times a factor kept by `update` was found too old and replaced
};

/// Solves A p = b for a symmetric positive definite A with positive diagonal. The matrix stays the caller's: the solver
/// reads it again in every solve, so it must outlive the solver's use of it.
class FlowSolver {
public:
  virtual ~FlowSolver() = default;

  /// What depends on the pattern alone: once per pattern.
  virtual void analyse(const FlowMatrix& matrix) = 0;
  /// What depends on the values: once per matrix, of the pattern analysed. Throws SolveError when the matrix is seen
  /// not to be positive definite.
  virtual void factor(const FlowMatrix& matrix) = 0;
  /// Instead of `factor` when the values have changed little: keeps the old factor as a preconditioner. A solve that
  /// finds it too old replaces it.
  virtual void update(const FlowMatrix& matrix) = 0;
  /// From a first guess to the answer, in place; a pressure of another size than the right side counts as zero. Throws
  /// SolveError when the matrix is not positive definite or the tolerance is not reached.
  virtual void solve(const Eigen::VectorXd& right_side, Eigen::VectorXd& pressure) = 0;

  virtual const SolverReport& report() const = 0;
};

/// Throws InputError on parameters out of range.
std::unique_ptr<FlowSolver> make_solver(const SolverChoice& choice);

} // namespace pfv
