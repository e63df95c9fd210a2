#pragma once

#include "pfv/clock.hpp"
#include "pfv/grains/contacts.hpp"
#include "pfv/grains/motion.hpp"

#include <functional>

namespace pfv {

/// What the grains are and what they do to one another.
struct GrainScene {
  double density = 2600; // kg/m^3
  ContactLaw law;
  Walls walls;
  LocalDamping damping;
  std::optional<Cohesion> cohesion;
  Vec3 gravity = Vec3::Zero(); // m/s^2

  bool operator==(const GrainScene&) const = default;
};

/// Where the energy went since the start (J). What loads and gravity put in is kinetic and elastic energy or one of the
/// losses.
struct EnergyBalance {
  double loads = 0;    // work of the stresses on loaded walls and of walls that move at a velocity
  double gravity = 0;  // work of the weight
  double friction = 0; // lost in contacts that slip
  double contact_damping = 0;
  double local_damping = 0;
  double fluid = 0; // taken by the fluid, with what its imposed pressures did

  double lost() const { return friction + contact_damping + local_damping + fluid; }
};

/// Grains, contacts and motion of a scene, advanced by leapfrog: stages `contacts` and `motion`, no others.
///
/// A step is begin_step (loads of contacts and gravity where grains are now), whatever else adds to `loads` and
/// `on_wall`, then end_step.
class GrainCycle {
public:
  GrainCycle(const Packing& packing, const GrainScene& scene);

  void begin_step(double step, Clock& clock);
  void end_step(double step, Clock& clock);

  /// Longest stable step (s) of the contacts alone: 2 / frequency.
  double contact_limit() const;
  /// Mean resultant force on a grain over the mean contact force, of the last begin_step.
  double unbalanced_force() const;

  Grains grains;
  Contacts contacts;
  GrainScene scene;
  std::vector<Load> loads;
  std::array<double, 6> on_wall{}; // N, along the axis
  EnergyBalance energy;
  std::size_t broken_bonds = 0;
  double time = 0; // s
};

} // namespace pfv
