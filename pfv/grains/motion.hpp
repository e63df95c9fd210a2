#pragma once

#include "pfv/grains/grains.hpp"
#include "pfv/grains/walls.hpp"

#include <span>

namespace pfv {

/// Cundall's damping: a force against the velocity, component by component, as large as `share` of the force there
/// (Cundall, in Crouch & Starfield's sense of "local" damping, 1987). Absent when zero.
struct LocalDamping {
  double share = 0;

  bool operator==(const LocalDamping&) const = default;
};

/// First half of a leapfrog step: velocities by the loads. Returns the energy (J) the damping took, and adds to `work`
/// that of the stresses on the loaded walls. `on_wall` is what grains and fluid do to the walls (N, along the axis).
struct Kick {
  double damped = 0;    // J
  double load_work = 0; // J, of the stresses on the loaded walls
};
Kick kick(Grains& grains, const Walls& walls, std::span<const Load> loads, const std::array<double, 6>& on_wall,
          const LocalDamping& damping, double step);

/// Second half: positions of grains and walls by the velocities.
void drift(Grains& grains, double step);

/// J, of translation and rotation of the grains and of the loaded walls.
double kinetic_energy(const Grains& grains, const Walls& walls);

/// Mean resultant force on a grain over the mean contact force: how far from equilibrium.
double unbalanced_force(const Grains& grains, std::span<const Load> loads, double mean_contact_force);

} // namespace pfv
