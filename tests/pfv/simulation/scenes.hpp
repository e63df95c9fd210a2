#pragma once

#include "pfv/grains/contact_list.hpp"
#include "pfv/problem/generate.hpp"
#include "pfv/simulation/simulation.hpp"

namespace pfv::testing {

/// A loose box of grains under a piston that drains both ends (Pa s, unit cube). The piston is as heavy as the grains.
inline Scene drained_box(int grains, double radius_ratio, double viscosity) {
  Scene scene;
  scene.packing = random_packing({.spheres = grains, .solid_fraction = 0.5, .radius_ratio = radius_ratio, .seed = 2});
  scene.grains.law = LinearSprings{1e6, 0.5, {0.5, 0}};
  scene.grains.walls.motion[index(Face::z_max)] = LoadedWall{1000, 2600 * 0.5};
  scene.fluid.emplace();
  scene.fluid->fluid.viscosity = viscosity;
  scene.fluid->faces[index(Face::z_min)] = scene.fluid->faces[index(Face::z_max)] = Pressure{0};
  return scene;
}

inline double height(const Simulation& simulation) {
  return simulation.grains().grains.packing.box.size().z();
}

/// Takes the steps, then kinetic and elastic energy and all that was lost over the work of the loads: 1 when nothing is
/// missing. Positions and velocities are half a step apart, so springs count in the middle of the last step.
inline double energy_balance(Simulation& simulation, int steps) {
  double elastic = 0;
  for (int n = 0; n < steps; ++n) {
    elastic = elastic_energy(simulation.grains().grains, simulation.grains().contacts);
    simulation.advance();
  }
  const GrainCycle& cycle = simulation.grains();
  elastic = 0.5 * (elastic + elastic_energy(cycle.grains, cycle.contacts));
  return (kinetic_energy(cycle.grains, cycle.scene.walls) + elastic + cycle.energy.lost()) / cycle.energy.loads;
}

} // namespace pfv::testing
