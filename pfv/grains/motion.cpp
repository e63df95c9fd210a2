#include "pfv/grains/motion.hpp"

#include <cmath>

namespace pfv {
namespace {

/// One component of velocity after a step; what the damping takes of its energy is added to `damped`.
double pushed(double velocity, double force, double share, double per_step, double step, double& damped) {
  const double brake = share * std::abs(force);
  const double next = velocity + per_step * (force - std::copysign(brake, velocity));
  damped += std::copysign(brake, velocity) * 0.5 * (velocity + next) * step;
  return next;
}

void push(Vec3& velocity, const Vec3& force, double share, double per_step, double step, double& damped) {
  if (share == 0) {
    velocity += per_step * force;
    return;
  }
  for (int axis = 0; axis < 3; ++axis)
    velocity[axis] = pushed(velocity[axis], force[axis], share, per_step, step, damped);
}

} // namespace

Kick kick(Grains& grains, const Walls& walls, std::span<const Load> loads, const std::array<double, 6>& on_wall,
          const LocalDamping& damping, double step) {
  Kick done;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    push(grains.velocity[i].translation, loads[i].force, damping.share, step / grains.mass[i], step, done.damped);
    push(grains.velocity[i].spin, loads[i].torque, damping.share, step / grains.inertia(i), step, done.damped);
  }
  for (const Face face : all_faces) {
    double& velocity = grains.wall_velocity[index(face)];
    if (const auto* moving = std::get_if<MovingWall>(&walls.motion[index(face)]))
      velocity = moving->velocity;
    if (const auto* loaded = std::get_if<LoadedWall>(&walls.motion[index(face)])) {
      const double inward = is_upper(face) ? -1 : 1;
      const double load = inward * loaded->stress * area_of(grains.packing.box, face);
      const double before = velocity;
      velocity = pushed(velocity, load + on_wall[index(face)], damping.share, step / loaded->mass, step, done.damped);
      done.load_work += load * 0.5 * (before + velocity) * step;
    }
  }
  return done;
}

void drift(Grains& grains, double step) {
  for (std::size_t i = 0; i < grains.size(); ++i)
    grains.packing.spheres[i].centre += step * grains.velocity[i].translation;
  for (const Face face : all_faces) {
    Vec3& corner = is_upper(face) ? grains.packing.box.upper : grains.packing.box.lower;
    corner[index(axis_of(face))] += step * grains.wall_velocity[index(face)];
  }
}

double kinetic_energy(const Grains& grains, const Walls& walls) {
  double twice = 0;
  for (std::size_t i = 0; i < grains.size(); ++i)
    twice += grains.mass[i] * grains.velocity[i].translation.squaredNorm() +
             grains.inertia(i) * grains.velocity[i].spin.squaredNorm();
  for (const Face face : all_faces)
    if (const auto* loaded = std::get_if<LoadedWall>(&walls.motion[index(face)]))
      twice += loaded->mass * grains.wall_velocity[index(face)] * grains.wall_velocity[index(face)];
  return 0.5 * twice;
}

double unbalanced_force(const Grains& grains, std::span<const Load> loads, double mean_contact_force) {
  double sum = 0;
  for (const Load& load : loads)
    sum += load.force.norm();
  return mean_contact_force > 0 ? sum / static_cast<double>(grains.size()) / mean_contact_force : 0;
}

} // namespace pfv
