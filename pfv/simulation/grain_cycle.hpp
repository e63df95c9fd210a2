#pragma once

#include "pfv/clock.hpp"
#include "pfv/grains/contacts.hpp"
#include "pfv/grains/films.hpp"
#include "pfv/grains/growth.hpp"
#include "pfv/grains/motion.hpp"
#include "pfv/simulation/body_forces.hpp"

#include <optional>

namespace pfv {

/// What the grains are and what they do to one another.
struct GrainScene {
  double density = 2600; // kg/m^3
  ContactLaw law;
  Walls walls;
  LocalDamping damping;
  std::optional<Cohesion> cohesion;
  std::vector<BodyForce> forces; // gravity and others
  std::optional<Lubrication> lubrication;
  std::optional<Growth> growth;

  bool operator==(const GrainScene&) const = default;
};

/// Where the energy went since the start (J). What loads, gravity and growth put in is kinetic and elastic energy or
/// one of the losses.
struct EnergyBalance {
  double loads = 0;    // work of stresses on loaded walls, of walls that move at a velocity, of imposed pressures
  double gravity = 0;  // work of the body forces: of the weight, less that of the displaced fluid
  double growth = 0;   // into the springs and the motion of grains whose radii grow
  double friction = 0; // lost in contacts that slip
  double contact_damping = 0;
  double local_damping = 0;
  double lubrication = 0; // dissipated in the films between grains
  double fluid = 0;       // dissipated by its flow, and stored where it is compressible

  double lost() const { return friction + contact_damping + local_damping + lubrication + fluid; }
};

/// Grains, contacts and motion of a scene, advanced by leapfrog: stages `contacts` and `motion`, with films
/// `lubrication`, with growth `growth`, no others.
///
/// A step is load (contacts, films and weight where grains are now), kick (velocities by these loads), whatever else
/// changes velocities, and drift (positions, and radii that grow).
class GrainCycle {
public:
  GrainCycle(const Packing& packing, const GrainScene& scene);
  /// Of grains that are in motion already, in their order.
  GrainCycle(Grains grains, const GrainScene& scene);

  /// Other laws, walls and loads from now on, for the same grains of the same density: a preparation's friction, say,
  /// makes way for that of the test. Contacts keep their springs; time and energies count on.
  void set_scene(const GrainScene& scene);

  void load(double step, Clock& clock);
  void kick(double step, Clock& clock);
  void drift(double step, Clock& clock);
  /// The kick where a fluid is still to push: damping and the work of loads come after it.
  void kick_undamped(double step, Clock& clock);
  /// Local damping of all that has changed the velocities since they were `before`: where a fluid carries part of the
  /// load, a brake in proportion to the rest of the forces would hold back even what creeps.
  void damp(std::span<const Vec3> bodies_before, std::span<const Velocity> before);
  /// All three: a step of grains alone.
  void advance(double step, Clock& clock);

  /// Longest stable step (s) of the contacts alone: 2 / frequency.
  double contact_limit() const;
  /// Of the films alone; nothing without.
  std::optional<double> lubrication_limit() const;
  /// Mean stress of the grains (Pa, compression negative): of their contacts, and of the films between them.
  Eigen::Matrix3d stress() const;
  /// Mean resultant force on a grain over the mean contact force, of the last load.
  double unbalanced_force() const;

  Grains grains;
  Contacts contacts;
  GrainScene scene;
  std::optional<Films> films;
  std::vector<Vec3> weight; // N, sum of the body forces in the last load; empty without any
  std::vector<Load> loads;
  std::array<double, 6> on_wall{}; // N, along the axis
  EnergyBalance energy;
  std::size_t broken_bonds = 0;
  double time = 0; // s

private:
  void set_films();
  void grow_radii(double step, Clock& clock);
};

} // namespace pfv
