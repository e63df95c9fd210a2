#include "pfv/simulation/pressure_solver.hpp"

#include "pfv/flow/steady_flow.hpp"
#include "pfv/problem/generate.hpp"
#include "pfv/simulation/solid_term.hpp"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

using namespace pfv;

namespace {

/// Flow between grains and the solid's motion within a step, both alike in size when `step` is.
struct Coupled {
  PoreNetwork network;
  FlowSystem system;
  GramTerm solid;

  explicit Coupled(double step) {
    Case problem;
    problem.packing = random_packing({.spheres = 150, .solid_fraction = 0.5, .radius_ratio = 2, .seed = 3});
    problem.faces = flow_along(Axis::z, 1.0);
    Clock clock;
    network = build_pore_network(problem.packing, {}, clock);
    system = assemble(network, conductances(network, HydraulicRadius{}, MirrorWalls{}, problem.fluid.viscosity),
                      problem.faces);
    const SolidFlux flux = solid_flux(network, MirrorWalls{});
    solid = solid_term(flux, system, std::vector<double>(flux.bodies, 1.0), step);
  }
  Eigen::MatrixXd dense() const {
    Eigen::MatrixXd all(system.matrix);
    Eigen::MatrixXd c = Eigen::MatrixXd::Zero(solid.rows(), 3 * solid.blocks());
    for (int i = 0; i < solid.rows(); ++i)
      for (int e = solid.by_row.start[i]; e < solid.by_row.start[i + 1]; ++e)
        c.row(i).segment<3>(3 * solid.by_row.entry[e].index) += solid.by_row.entry[e].value;
    return all + c * c.transpose();
  }
  Eigen::VectorXd right_side(int number) const {
    Eigen::VectorXd b(solid.rows());
    for (Eigen::Index i = 0; i < b.size(); ++i)
      b[i] = std::sin((1.0 + number) * (1.0 + static_cast<double>(i)));
    return b;
  }
};

/// |e| of the answer over |x|, in the norm of the matrix.
double error(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right_side, const Eigen::VectorXd& x) {
  const Eigen::VectorXd exact = matrix.llt().solve(right_side), off = x - exact;
  return std::sqrt(off.dot(matrix * off) / exact.dot(matrix * exact));
}

TEST(PressureSolver, ProductIsThatOfBothTerms) {
  const Coupled of(1e-3);
  const Eigen::VectorXd x = of.right_side(0);
  Eigen::VectorXd product;
  std::vector<Vec3> room;
  const double power = multiply(of.system.matrix, of.solid, x, room, product);
  const Eigen::VectorXd expected = of.dense() * x;
  EXPECT_LT((product - expected).norm(), 1e-13 * expected.norm());
  EXPECT_NEAR(power, x.dot(expected), 1e-13 * std::abs(x.dot(expected)));
}

TEST(PressureSolver, KeepsItsToleranceWhateverTheSolidHasOfTheMatrix) {
  for (const double step : {0.0, 1e-6, 1e-3, 1.0}) {
    const Coupled of(step);
    const Eigen::MatrixXd dense = of.dense();
    PressureSolver solver;
    solver.set(of.system.matrix, of.solid);
    for (const double tolerance : {1e-3, 1e-6}) {
      Eigen::VectorXd x = Eigen::VectorXd::Zero(of.solid.rows());
      solver.solve(of.right_side(1), tolerance, x);
      EXPECT_LT(error(dense, of.right_side(1), x), 2 * tolerance) << step; // what the V-cycle tells of the norm
    }
  }
}

TEST(PressureSolver, GuessesWhatPastIncrementsMakeUp) {
  const Coupled of(1e-3);
  const Eigen::MatrixXd dense = of.dense();
  PressureSolver solver;
  solver.set(of.system.matrix, of.solid);
  PastIncrements past;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(of.solid.rows());
  for (int n = 0; n < 3; ++n)
    EXPECT_GT(solver.solve(of.right_side(n), 1e-8, x, &past), 5);
  const Eigen::VectorXd mixed = of.right_side(0) - 2 * of.right_side(1) + 3 * of.right_side(2);
  EXPECT_LE(solver.solve(mixed, 1e-6, x, &past), 1);
  EXPECT_LT(error(dense, mixed, x), 2e-6);
}

// Increments are then round-off, of which a guess made pressures grow a thousandfold from solve to solve.
TEST(PressureSolver, StaysAtTheSolutionWhenNothingChanges) {
  const Coupled of(1e-3);
  const Eigen::MatrixXd dense = of.dense();
  PressureSolver solver;
  solver.set(of.system.matrix, of.solid);
  for (const double tolerance : {1e-4, 1e-6, 1e-10})
    for (const double wobble : {0.0, 1e-12, 1e-9, 1e-7, 1e-5}) {
      PastIncrements past;
      Eigen::VectorXd x = Eigen::VectorXd::Zero(of.solid.rows());
      for (int n = 1; n < 60; ++n) {
        const Eigen::VectorXd right_side = of.right_side(0) + wobble * of.right_side(n);
        solver.solve(right_side, tolerance, x, &past);
        ASSERT_LT(error(dense, right_side, x), 3 * tolerance) << tolerance << ' ' << wobble << ' ' << n;
      }
    }
}

} // namespace
