#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace pfv {

/// Supernodal or simplicial Cholesky factorisation by CHOLMOD (SuiteSparse).
struct Cholmod {};

/// Over-relaxed Gauss-Seidel, the solver of Catalano et al. 2011, section 5.
struct GaussSeidel {
  std::optional<double> relaxation; // 0 < relaxation < 2; adapted to the matrix when absent
  double tolerance = 1e-12;         // of |b - A p| / |b|
  int largest_sweeps = 200000;
};

/// Chosen by size; today always CHOLMOD.
struct AutoSolver {};

using SolverChoice = std::variant<AutoSolver, Cholmod, GaussSeidel>;

/// Reads "auto", "cholmod" or "gauss-seidel". Throws InputError.
SolverChoice solver_named(std::string_view name);

struct SolverReport {
  std::string name;
  int iterations = 0;             // sweeps; refinement steps of a direct solver
  std::size_t factor_entries = 0; // nonzeros of the Cholesky factor
  double residual = 0;            // |b - A p| / |b|
  double relaxation = 0;          // last one used, of Gauss-Seidel
};

/// Solves A p = b for a symmetric positive definite A of which the lower triangle is stored.
class FlowSolver {
public:
  virtual ~FlowSolver() = default;

  /// Orders and factors, once per matrix. Throws SolveError when the matrix is not positive definite.
  virtual void factor(const Eigen::SparseMatrix<double>& lower) = 0;
  /// Throws SolveError when it does not reach its tolerance.
  virtual Eigen::VectorXd solve(const Eigen::VectorXd& right_side) = 0;

  const SolverReport& report() const { return report_; }

protected:
  SolverReport report_;
};

std::unique_ptr<FlowSolver> make_solver(const SolverChoice& choice);

} // namespace pfv
