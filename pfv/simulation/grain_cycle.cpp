#include "pfv/simulation/grain_cycle.hpp"

#include "pfv/grains/contact_list.hpp"
#include "pfv/problem/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace pfv {

GrainCycle::GrainCycle(const Packing& packing, const GrainScene& of_scene)
    : GrainCycle(grains_of(packing, of_scene.density, of_scene.walls.periodic), of_scene) {}

GrainCycle::GrainCycle(Grains of_grains, const GrainScene& of_scene)
    : grains(std::move(of_grains)), contacts(of_scene.law, of_scene.walls.friction, of_scene.cohesion, grains),
      loads(grains.size()) {
  set_scene(of_scene);
}

void GrainCycle::set_scene(const GrainScene& next) {
  scene = next;
  contacts.set_law(scene.law, scene.walls.friction);
  set_films();
  weight = sum_of(scene.forces, grains, time);
  for (const Face face : all_faces) {
    const auto* moving = std::get_if<MovingWall>(&scene.walls.motion[index(face)]);
    if (moving || std::holds_alternative<FixedWall>(scene.walls.motion[index(face)]))
      grains.wall_velocity[index(face)] = moving ? moving->velocity : 0;
  }
}

void GrainCycle::set_films() {
  films.reset();
  if (scene.lubrication) {
    require_wide(grains.packing, grains.periodic, scene.lubrication->reach);
    films.emplace(*scene.lubrication, grains.size());
  }
  contacts.set_reach(scene.lubrication ? scene.lubrication->reach : 0, grains);
}

void GrainCycle::load(double step, Clock& clock) {
  {
    const auto timing = clock.stage("contacts");
    loads.assign(grains.size(), {});
    on_wall.fill(0);
    const ContactLosses losses = contacts.add_forces(grains, step, loads, on_wall);
    energy.friction += losses.friction;
    energy.contact_damping += losses.damping;
    broken_bonds += losses.broken_bonds;
    if (changes(scene.forces) || scene.growth)
      weight = sum_of(scene.forces, grains, time);
    for (std::size_t i = 0; i < weight.size(); ++i)
      loads[i].force += weight[i];
  }
  if (!films)
    return;
  const auto timing = clock.stage("lubrication");
  films->add_forces(grains, contacts.memory().pairs, contacts.memory().at_walls, loads, on_wall);
}

void GrainCycle::kick(double step, Clock& clock) {
  const auto timing = clock.stage("motion");
  const Kick done = pfv::kick(grains, scene.walls, loads, on_wall, scene.damping, step);
  energy.local_damping += done.damped;
  energy.loads += done.load_work;
}

void GrainCycle::kick_undamped(double step, Clock& clock) {
  const auto timing = clock.stage("motion");
  pfv::kick(grains, scene.walls, loads, on_wall, {}, step);
}

void GrainCycle::damp(std::span<const Vec3> bodies_before, std::span<const Velocity> before) {
  const double share = scene.damping.share;
  if (share == 0)
    return;
  const auto brake = [&](double mass, double old, double& velocity) {
    const double taken = std::copysign(share * std::abs(velocity - old), old);
    velocity -= taken;
    energy.local_damping += mass * taken * 0.5 * (old + velocity);
  };
  for (std::size_t i = 0; i < grains.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      brake(grains.mass[i], before[i].translation[axis], grains.velocity[i].translation[axis]);
      brake(grains.inertia(i), before[i].spin[axis], grains.velocity[i].spin[axis]);
    }
  for (std::size_t face = 0; face < 6; ++face)
    if (const auto* loaded = std::get_if<LoadedWall>(&scene.walls.motion[face]))
      brake(loaded->mass, bodies_before[grains.size() + face][face / 2], grains.wall_velocity[face]);
}

void GrainCycle::drift(double step, Clock& clock) {
  if (films) {
    const auto timing = clock.stage("lubrication");
    energy.lubrication += films->taken(grains, step);
  }
  const auto timing = clock.stage("motion");
  for (const Face face : all_faces)
    if (std::holds_alternative<MovingWall>(scene.walls.motion[index(face)]))
      energy.loads -= on_wall[index(face)] * grains.wall_velocity[index(face)] * step;
  pfv::drift(grains, step);
  time += step;
  for (std::size_t i = 0; i < weight.size(); ++i)
    energy.gravity += weight[i].dot(grains.velocity[i].translation) * step;
  if (scene.growth)
    grow_radii(step, clock);
}

void GrainCycle::grow_radii(double step, Clock& clock) {
  const auto timing = clock.stage("growth");
  const auto list = contact_list(grains, contacts);
  const double stress = mean_stress(contact_stress(grains, list, contacts.law()));
  // Never smaller than they began.
  const double factor = std::max(std::exp(step * growth_rate(*scene.growth, stress)), 1 / grains.grown);
  energy.growth += growth_work(grains, list, contacts.law(), factor);
  pfv::grow(grains, factor, scene.density);
  contacts.note_growth(std::abs(factor - 1) * std::ranges::max(grains.packing.spheres, {}, &Sphere::radius).radius);
}

void GrainCycle::advance(double step, Clock& clock) {
  load(step, clock);
  kick(step, clock);
  drift(step, clock);
}

double GrainCycle::contact_limit() const {
  return 2 / std::sqrt(largest_square_frequency(grains, contacts));
}

std::optional<double> GrainCycle::lubrication_limit() const {
  if (!films)
    return std::nullopt;
  return 2 / films->largest_rate(grains, scene.walls, contacts.memory().pairs, contacts.memory().at_walls);
}

Eigen::Matrix3d GrainCycle::stress() const {
  Eigen::Matrix3d sum = contact_stress(grains, contacts);
  if (films)
    sum += films->stress(grains, contacts.memory().pairs, contacts.memory().at_walls);
  return sum;
}

double GrainCycle::unbalanced_force() const {
  const auto list = contact_list(grains, contacts);
  double sum = 0;
  for (const Contact& contact : list) {
    const Springs springs =
        std::visit([&](const auto& law) { return law.springs(contact.radius, contact.overlap); }, contacts.law());
    sum += std::hypot(springs.force, contact.shear.norm());
  }
  return pfv::unbalanced_force(grains, loads, list.empty() ? 0 : sum / static_cast<double>(list.size()));
}

} // namespace pfv
