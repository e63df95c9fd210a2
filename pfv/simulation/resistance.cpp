#include "pfv/simulation/resistance.hpp"

#include "pfv/flow/flow_system.hpp"
#include "pfv/solvers/flow_solver.hpp"

#include <Eigen/Eigenvalues>

namespace pfv {

Eigen::MatrixXd resistance(const FlowSystem& system, const SolidFlux& rates, const SolidFlux& forces) {
  const auto solver = make_solver(Cholmod{});
  solver->analyse(system.matrix);
  solver->factor(system.matrix);
  const auto motions = static_cast<Eigen::Index>(3 * (forces.bodies - 6));
  Eigen::MatrixXd result(motions, motions);
  Eigen::VectorXd right, pressure;
  std::vector<double> rate;
  std::vector<Vec3> force;
  for (Eigen::Index m = 0; m < motions; ++m) {
    std::vector<Vec3> velocity(forces.bodies, Vec3::Zero());
    velocity[static_cast<std::size_t>(m / 3)] = Vec3::Unit(m % 3);
    volume_rates(rates, velocity, rate);
    right.setZero(static_cast<Eigen::Index>(system.unknowns()));
    for (std::size_t i = 0; i < rate.size(); ++i)
      if (const int unknown = system.unknown_of_pore[i]; unknown >= 0)
        right[unknown] -= rate[i];
    solver->solve(right, pressure);
    pressure_forces(forces, pore_pressures(system, pressure), force);
    for (Eigen::Index n = 0; n < motions; ++n)
      result(n, m) = -force[static_cast<std::size_t>(n / 3)][n % 3];
  }
  return result;
}

Passivity passivity(const Eigen::MatrixXd& resistance) {
  const Eigen::MatrixXd symmetric = 0.5 * (resistance + resistance.transpose());
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
  return {values.minCoeff() / values.maxCoeff(), (resistance - resistance.transpose()).norm() / resistance.norm()};
}

} // namespace pfv
