#include "pfv/flow/flow_solver.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "support/message_of.hpp"
#include "support/packings.hpp"

#include <gtest/gtest.h>

using namespace pfv;
using namespace pfv::testing;

namespace {

/// Second differences on a line with both ends held: eigenvalues 2 - 2 cos(k pi / (n + 1)).
Eigen::SparseMatrix<double> laplacian(int n, double diagonal = 2) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, diagonal);
    if (i > 0)
      entries.emplace_back(i, i - 1, -1);
  }
  Eigen::SparseMatrix<double> lower(n, n);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

TEST(FlowSolver, EnginesSolveALine) {
  constexpr int n = 50;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  right[0] = 1; // p = 1 before the first, 0 behind the last
  for (const SolverChoice& choice :
       {SolverChoice(Cholmod{}), SolverChoice(GaussSeidel{}), SolverChoice(AutoSolver{})}) {
    const auto solver = make_solver(choice);
    solver->factor(laplacian(n));
    const auto p = solver->solve(right);
    for (int i = 0; i < n; ++i)
      EXPECT_NEAR(p[i], 1 - (i + 1.0) / (n + 1), 1e-9) << solver->report().name;
  }
}

TEST(FlowSolver, GaussSeidelFindsAnOverRelaxationNearTheOptimum) {
  constexpr int n = 100; // optimum 2 / (1 + sin(pi / 101)) = 1.94
  const auto sweeps = [](std::optional<double> relaxation) {
    GaussSeidel parameters;
    parameters.relaxation = relaxation;
    const auto solver = make_solver(parameters);
    solver->factor(laplacian(n));
    solver->solve(Eigen::VectorXd::Ones(n));
    return solver->report().iterations;
  };
  EXPECT_LT(sweeps(std::nullopt), 1.5 * sweeps(1.94));
  EXPECT_GT(sweeps(1.0), 10 * sweeps(std::nullopt));
}

TEST(FlowSolver, GaussSeidelSaysWhenItDoesNotConverge) {
  GaussSeidel parameters;
  parameters.largest_sweeps = 40;
  const auto solver = make_solver(parameters);
  solver->factor(laplacian(1000));
  EXPECT_NE(message_of<SolveError>([&] { solver->solve(Eigen::VectorXd::Ones(1000)); }).find("40 sweeps"),
            std::string::npos);
}

TEST(FlowSolver, RefusesWhatIsNotPositiveDefiniteOrNotAllowed) {
  const auto solver = make_solver(Cholmod{});
  EXPECT_THROW(solver->factor(laplacian(20, -2)), SolveError);
  EXPECT_THROW(make_solver(GaussSeidel{.relaxation = 2.0}), InputError);
  EXPECT_EQ(message_of<InputError>([] { solver_named("jacobi"); }),
            "solver \"jacobi\" is not one of auto, cholmod, gauss-seidel");
}

TEST(FlowSolver, EnginesAgreeOnPermeabilityAndForces) {
  for (const char* file : {"bcc9.txt", "bcc9jit.txt", "g200.txt", "g2000.txt"}) {
    const auto problem = flow_through(packing_from(file));
    const auto direct = solved(problem, {.solver = Cholmod{}});
    const auto relaxed = solved(problem, {.solver = GaussSeidel{}});
    EXPECT_NEAR(*relaxed.permeability / *direct.permeability, 1, 1e-8) << file;
    double difference = 0, total = 0;
    for (std::size_t k = 0; k < direct.forces.pressure.size(); ++k) {
      difference = std::max(difference, (relaxed.forces.of_flow(k) - direct.forces.of_flow(k)).norm());
      total += direct.forces.of_flow(k).squaredNorm();
    }
    EXPECT_LT(difference, 1e-7 * std::sqrt(total / static_cast<double>(direct.forces.pressure.size()))) << file;
  }
}

} // namespace
