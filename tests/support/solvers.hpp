#pragma once

#include "pfv/solvers/flow_solver.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace pfv::testing {

inline constexpr std::array all_engines = {"cholmod", "gauss-seidel", "amg", "multigrid", "auto"};

struct Link {
  int first, second;
  double conductance;
};

/// Conductances between unknowns, and of each unknown to a known pressure.
inline FlowMatrix network_matrix(const std::vector<double>& to_known, const std::vector<Link>& links) {
  std::vector<Eigen::Triplet<double>> entries;
  const int n = static_cast<int>(to_known.size());
  for (int i = 0; i < n; ++i)
    entries.emplace_back(i, i, to_known[i]);
  for (const auto& [i, j, k] : links) {
    entries.emplace_back(i, i, k);
    entries.emplace_back(j, j, k);
    entries.emplace_back(i, j, -k);
    entries.emplace_back(j, i, -k);
  }
  FlowMatrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// Second differences on a line with both ends held: eigenvalues diagonal - 2 cos(k pi / (n + 1)).
inline FlowMatrix laplacian(int n, double diagonal = 2) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, diagonal);
    if (i > 0) {
      entries.emplace_back(i, i - 1, -1);
      entries.emplace_back(i - 1, i, -1);
    }
  }
  FlowMatrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

inline Eigen::VectorXd answer(const SolverChoice& choice, const FlowMatrix& matrix, const Eigen::VectorXd& right) {
  const auto solver = make_solver(choice);
  solver->analyse(matrix);
  solver->factor(matrix);
  Eigen::VectorXd pressure;
  solver->solve(right, pressure);
  return pressure;
}

inline Eigen::VectorXd answer(const char* engine, const FlowMatrix& matrix, const Eigen::VectorXd& right) {
  return answer(solver_named(engine), matrix, right);
}

} // namespace pfv::testing
