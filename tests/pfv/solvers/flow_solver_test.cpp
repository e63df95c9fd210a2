#include "pfv/solvers/flow_solver.hpp"

#include "pfv/problem/error.hpp"
#include "support/message_of.hpp"
#include "support/solvers.hpp"

#include <gtest/gtest.h>

using namespace pfv;
using namespace pfv::testing;

namespace {

TEST(FlowSolver, EnginesSolveALine) {
  constexpr int n = 300;
  const auto matrix = laplacian(n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  right[0] = 1; // p = 1 before the first, 0 behind the last
  for (const char* engine : all_engines) {
    const auto p = answer(engine, matrix, right);
    for (int i = 0; i < n; ++i)
      EXPECT_NEAR(p[i], 1 - (i + 1.0) / (n + 1), 1e-8) << engine;
  }
}

TEST(FlowSolver, NamesItsEngines) {
  for (const char* engine : {"cholmod", "gauss-seidel", "amg", "multigrid"})
    EXPECT_EQ(make_solver(solver_named(engine))->report().name, engine);
}

TEST(FlowSolver, AutoFactorsWhatIsSmallOrOftenReused) {
  const auto chosen = [](int unknowns, int solves_per_matrix) {
    const auto solver = make_solver(AutoSolver{solves_per_matrix});
    solver->analyse(laplacian(unknowns));
    return solver->report().name;
  };
  EXPECT_EQ(chosen(100, 1), "cholmod");
  EXPECT_EQ(chosen(20000, 1), "multigrid");
  EXPECT_EQ(chosen(20000, 1000), "cholmod");
  EXPECT_EQ(chosen(400000, 1000), "multigrid");
}

TEST(FlowSolver, GaussSeidelFindsAnOverRelaxationNearTheOptimum) {
  constexpr int n = 100; // optimum 2 / (1 + sin(pi / 101)) = 1.94
  const auto sweeps = [](std::optional<double> relaxation) {
    GaussSeidel parameters;
    parameters.relaxation = relaxation;
    const auto solver = make_solver(parameters);
    const auto matrix = laplacian(n);
    solver->factor(matrix);
    Eigen::VectorXd p;
    solver->solve(Eigen::VectorXd::Ones(n), p);
    return solver->report().iterations;
  };
  EXPECT_LT(sweeps(std::nullopt), 1.5 * sweeps(1.94));
  EXPECT_GT(sweeps(1.0), 10 * sweeps(std::nullopt));
}

TEST(FlowSolver, GaussSeidelSaysWhenItDoesNotConverge) {
  GaussSeidel parameters;
  parameters.largest_sweeps = 40;
  const auto solver = make_solver(parameters);
  const auto matrix = laplacian(1000);
  solver->factor(matrix);
  Eigen::VectorXd p;
  EXPECT_NE(message_of<SolveError>([&] { solver->solve(Eigen::VectorXd::Ones(1000), p); }).find("40 sweeps"),
            std::string::npos);
}

TEST(FlowSolver, AGuessHelpsOrDoesNoHarm) {
  constexpr int n = 1000;
  const auto matrix = laplacian(n);
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(n, 0, 1);
  for (const char* engine : {"amg", "multigrid"}) {
    const auto solver = make_solver(solver_named(engine));
    solver->analyse(matrix);
    solver->factor(matrix);
    const Eigen::VectorXd solution = answer("cholmod", matrix, right);
    const auto iterations_from = [&](Eigen::VectorXd p) {
      solver->solve(right, p);
      EXPECT_LT((p - solution).norm(), 1e-8 * solution.norm()) << engine;
      return solver->report().iterations;
    };
    const int from_nothing = iterations_from(Eigen::VectorXd::Zero(n));
    EXPECT_LT(iterations_from((1 + 1e-6) * solution), from_nothing) << engine;
    for (const double times : {-1e12, -1.0, 3.0, 1e12}) // worse than none
      EXPECT_EQ(iterations_from(times * solution), from_nothing) << engine << ' ' << times;
  }
}

TEST(FlowSolver, RefusesWhatIsNotPositiveDefinite) {
  for (const char* engine : all_engines)
    for (const double diagonal : {-2.0, 0.0, 1.0}) { // 1: eigenvalues from -1 to 3
      const auto matrix = laplacian(150, diagonal);
      EXPECT_NE(message_of<SolveError>([&] {
                  answer(engine, matrix, Eigen::VectorXd::Ones(150));
                }).find("not positive definite"),
                std::string::npos)
          << engine << " " << diagonal;
    }
}

TEST(FlowSolver, RefusesParametersOutOfRange) {
  EXPECT_THROW(make_solver(GaussSeidel{.relaxation = 2.0}), InputError);
  EXPECT_THROW(make_solver(Multigrid{.tolerance = 0}), InputError);
  EXPECT_THROW(make_solver(Amg{.tolerance = 1}), InputError);
  EXPECT_THROW(make_solver(AutoSolver{.solves_per_matrix = 0}), InputError);
  EXPECT_EQ(message_of<InputError>([] { solver_named("jacobi"); }),
            "solver \"jacobi\" is not one of auto, cholmod, gauss-seidel, amg, multigrid");
}

TEST(FlowSolver, RefusesARightSideThatIsNotFinite) {
  const auto matrix = laplacian(10);
  for (const char* engine : all_engines)
    EXPECT_THROW(answer(engine, matrix, Eigen::VectorXd::Constant(10, std::nan(""))), SolveError) << engine;
}

} // namespace
