#pragma once

#include "pfv/simulation/simulation.hpp"

namespace pfv {

/// Advances a simulation and keeps its energies together. Positions and velocities are half a step apart, so springs
/// count in the middle of the last step.
class EnergyAccount {
public:
  explicit EnergyAccount(Simulation& simulation);

  /// One step. Throws what Simulation::advance throws.
  void advance();

  double kinetic() const; // J, of grains and loaded walls
  double elastic() const; // J, in the springs
  /// Kinetic and elastic energy and all that was lost, over the work of loads and growth: 1 when nothing is missing, of
  /// a scene without weight that began at rest and without springs.
  double accounted() const;

private:
  Simulation& simulation_;
  double elastic_before_;
};

} // namespace pfv
