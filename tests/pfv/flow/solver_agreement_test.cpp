#include "pfv/problem/generate.hpp"
#include "support/packings.hpp"
#include "support/solvers.hpp"

#include <gtest/gtest.h>

using namespace pfv;
using namespace pfv::testing;

namespace {

std::vector<std::pair<std::string, Packing>> packings() {
  return {{"nine spheres, moved", packing_from("bcc9jit.txt")},
          {"200 spheres", packing_from("g200.txt")},
          {"2000 spheres", packing_from("g2000.txt")},
          {"lattice", lattice_packing(Lattice::fcc, 0.6, 4)},
          {"two sizes", random_packing({.spheres = 600, .solid_fraction = 0.45, .radius_ratio = 4})}};
}

/// Largest difference of the force on a sphere, in units of the root mean square of the forces.
double force_difference(const SteadyFlow& flow, const SteadyFlow& reference) {
  double difference = 0, total = 0;
  const std::size_t spheres = reference.forces.pressure.size();
  for (std::size_t k = 0; k < spheres; ++k) {
    difference = std::max(difference, (flow.forces.of_flow(k) - reference.forces.of_flow(k)).norm());
    total += reference.forces.of_flow(k).squaredNorm();
  }
  return difference / std::sqrt(total / static_cast<double>(spheres));
}

TEST(SolverAgreement, OnPermeabilityAndEveryForce) {
  for (const auto& [name, packing] : packings()) {
    const auto problem = flow_through(packing);
    const auto reference = solved(problem, {.solver = Cholmod{}});
    for (const char* engine : all_engines) {
      const auto flow = solved(problem, {.solver = solver_named(engine)});
      EXPECT_NEAR(*flow.permeability / *reference.permeability, 1, 1e-8) << name << ", " << engine;
      EXPECT_LT(force_difference(flow, reference), 1e-7) << name << ", " << engine;
    }
  }
}

/// The pressures of a network whose conductances have changed by up to `change` of themselves.
FlowMatrix changed(const FlowMatrix& matrix, double change) {
  FlowMatrix result = matrix;
  const Eigen::VectorXd to_known = matrix * Eigen::VectorXd::Ones(matrix.rows());
  Eigen::VectorXd diagonal = to_known;
  for (int i = 0; i < result.rows(); ++i)
    for (FlowMatrix::InnerIterator entry(result, i); entry; ++entry)
      if (entry.col() != i) {
        entry.valueRef() *= 1 + change * std::sin(static_cast<double>(i) + static_cast<double>(entry.col()));
        diagonal[i] -= entry.value();
      }
  for (int i = 0; i < result.rows(); ++i)
    result.coeffRef(i, i) = diagonal[i];
  return result;
}

TEST(SolverAgreement, OfAnUpdateWithAFreshFactor) {
  for (const auto& [name, packing] : packings()) {
    const auto system = solved(flow_through(packing)).system;
    if (system.unknowns() == 0)
      continue;
    for (const char* engine : {"cholmod", "amg", "multigrid"}) {
      const auto solver = make_solver(solver_named(engine));
      solver->analyse(system.matrix);
      solver->factor(system.matrix);
      Eigen::VectorXd pressure;
      solver->solve(system.right_side, pressure);
      for (const double change : {1e-3, 1e-2, 0.3}) {
        const auto matrix = changed(system.matrix, change);
        const auto reference = answer("cholmod", matrix, system.right_side);
        solver->update(matrix);
        solver->solve(system.right_side, pressure);
        EXPECT_LT((pressure - reference).lpNorm<Eigen::Infinity>(), 1e-8 * reference.lpNorm<Eigen::Infinity>())
            << name << ", " << engine << ", " << change;
      }
      EXPECT_EQ(solver->report().refactored, 0) << name << ", " << engine;
    }
  }
}

TEST(SolverAgreement, ReplacesAFactorThatIsTooOld) {
  const auto system = solved(flow_through(packing_from("g2000.txt"))).system;
  FlowMatrix other = system.matrix; // each unknown has its own scale
  const Eigen::VectorXd scale = Eigen::VectorXd::LinSpaced(other.rows(), -3, 3).array().exp();
  for (int i = 0; i < other.rows(); ++i)
    for (FlowMatrix::InnerIterator entry(other, i); entry; ++entry)
      entry.valueRef() *= scale[(37 * i) % other.rows()] * scale[(37 * entry.col()) % other.rows()];
  const auto reference = answer("cholmod", other, system.right_side);
  for (const char* engine : {"cholmod", "amg", "multigrid"}) {
    const auto solver = make_solver(solver_named(engine));
    solver->analyse(system.matrix);
    solver->factor(system.matrix);
    solver->update(other);
    Eigen::VectorXd pressure;
    for (int solve = 0; solve < 2; ++solve)
      solver->solve(system.right_side, pressure);
    EXPECT_EQ(solver->report().refactored, 1) << engine;
    EXPECT_LT((pressure - reference).lpNorm<Eigen::Infinity>(), 1e-7 * reference.lpNorm<Eigen::Infinity>()) << engine;
  }
}

TEST(SolverAgreement, StartsFromTheFirstGuess) {
  const auto system = solved(flow_through(packing_from("g2000.txt"))).system;
  const auto reference = answer("cholmod", system.matrix, system.right_side);
  for (const char* engine : all_engines) {
    const auto solver = make_solver(solver_named(engine));
    solver->analyse(system.matrix);
    solver->factor(system.matrix);
    Eigen::VectorXd pressure;
    solver->solve(system.right_side, pressure);
    const int cold = solver->report().iterations;
    solver->solve(system.right_side, pressure);
    EXPECT_LE(solver->report().iterations, std::max(1, cold / 4)) << engine;
    pressure = Eigen::VectorXd::Constant(reference.size(), -1e3);
    solver->solve(system.right_side, pressure);
    EXPECT_LT((pressure - reference).lpNorm<Eigen::Infinity>(), 1e-8 * reference.lpNorm<Eigen::Infinity>()) << engine;
  }
}

} // namespace
