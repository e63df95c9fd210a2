#include "pfv/grains/contacts.hpp"

#include "pfv/grains/contact_force.hpp"

#include <algorithm>
#include <cmath>

namespace pfv {
namespace {

constexpr double margin_of_radius = 0.1; // of the mean radius: measured, .05 to .2 are alike

double mean_radius(const Grains& grains) {
  double sum = 0;
  for (const Sphere& sphere : grains.packing.spheres)
    sum += sphere.radius;
  return sum / static_cast<double>(grains.size());
}

std::array<double, 6> wall_positions(const Box& box) {
  std::array<double, 6> position;
  for (const Face face : all_faces)
    position[index(face)] = (is_upper(face) ? box.upper : box.lower)[index(axis_of(face))];
  return position;
}

template <bool periodic, class Law, class Bonds>
void add_pair_forces(const Law& law, const Bonds& bonds, const Grains& grains, double step, CandidatePairs& pairs,
                     std::vector<Load>& loads, ContactLosses& losses) {
  const bool damped = law.friction.damping > 0;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const Sphere a = grains.sphere(i);
    const Velocity of_a = grains.velocity[i];
    Load on_a;
    for (int e = pairs.start[i]; e < pairs.start[i + 1]; ++e) {
      const int j = pairs.other[e];
      const Sphere& b = grains.sphere(j);
      Vec3 apart = b.centre - a.centre;
      if constexpr (periodic)
        apart += pairs.image[e];
      const double square = apart.squaredNorm(), reach = a.radius + b.radius;
      Bond& bond = pairs.bond[e];
      if (square >= reach * reach && !Bonds::holds(bond)) {
        if (bond != Bond::none) {
          bond = Bond::none;
          pairs.shear[e].setZero();
        }
        continue;
      }
      if (bond == Bond::none)
        bond = Bond::touching;
      const Velocity& of_b = grains.velocity[j];
      const double distance = std::sqrt(square);
      Meeting at;
      at.normal = apart / distance;
      at.overlap = reach - distance;
      at.radius = a.radius * b.radius / reach;
      at.smaller = std::min(a.radius, b.radius);
      const double arm_a = a.radius - 0.5 * at.overlap, arm_b = b.radius - 0.5 * at.overlap;
      at.sliding = of_b.translation - of_a.translation - (arm_a * of_a.spin + arm_b * of_b.spin).cross(at.normal);
      at.twist = 0.5 * (of_a.spin + of_b.spin).dot(at.normal);
      at.reduced_mass = damped ? grains.mass[i] * grains.mass[j] / (grains.mass[i] + grains.mass[j]) : 0;
      const Vec3 force = contact_force(law, bonds, law.friction.coefficient, at, step, pairs.shear[e], bond, losses);
      const Vec3 turn = at.normal.cross(force);
      on_a.force += force;
      on_a.torque += arm_a * turn;
      loads[j].force -= force;
      loads[j].torque += arm_b * turn;
    }
    loads[i].force += on_a.force;
    loads[i].torque += on_a.torque;
  }
}

template <class Law>
void add_wall_forces(const Law& law, double friction, const Grains& grains, double step, CandidateWalls& at_walls,
                     std::vector<Load>& loads, std::array<double, 6>& on_wall, ContactLosses& losses) {
  const auto wall_position = wall_positions(grains.packing.box);
  for (const Face face : all_faces) {
    const int axis = index(axis_of(face));
    const Vec3 outward = outward_normal(face);
    for (auto& contact : at_walls.of_face[index(face)]) {
      const Sphere& sphere = grains.sphere(contact.grain);
      const double distance = (wall_position[index(face)] - sphere.centre[axis]) * outward[axis];
      if (distance >= sphere.radius) {
        contact.bond = Bond::none;
        contact.shear.setZero();
        continue;
      }
      contact.bond = Bond::touching;
      const Velocity& velocity = grains.velocity[contact.grain];
      const double overlap = sphere.radius - distance;
      Meeting at;
      at.normal = outward;
      at.overlap = overlap;
      at.radius = at.smaller = sphere.radius;
      at.sliding = -velocity.translation - (distance * velocity.spin).cross(outward);
      at.sliding[axis] += grains.wall_velocity[index(face)];
      at.twist = 0.5 * velocity.spin.dot(outward);
      at.reduced_mass = grains.mass[contact.grain];
      const Vec3 force = contact_force(law, NoBonds{}, friction, at, step, contact.shear, contact.bond, losses);
      loads[contact.grain].force += force;
      loads[contact.grain].torque += distance * outward.cross(force);
      on_wall[index(face)] -= force[axis];
    }
  }
}

} // namespace

Contacts::Contacts(const ContactLaw& law, double wall_friction, const std::optional<Cohesion>& cohesion,
                   const Grains& grains)
    : law_(law), wall_friction_(wall_friction), cohesion_(cohesion) {
  renew(grains);
  if (!cohesion)
    return;
  for (std::size_t i = 0; i < grains.size(); ++i)
    for (int e = memory_.pairs.start[i]; e < memory_.pairs.start[i + 1]; ++e) {
      const Sphere &a = grains.sphere(i), &b = grains.sphere(memory_.pairs.other[e]);
      if (apart(memory_.pairs, e, a, b).norm() <= a.radius + b.radius)
        memory_.pairs.bond[e] = Bond::cemented;
    }
}

ContactLosses Contacts::add_forces(const Grains& grains, double step, std::vector<Load>& loads,
                                   std::array<double, 6>& on_wall) {
  renew_if_moved(grains, step);
  ContactLosses losses;
  std::visit(
      [&](const auto& law) {
        const auto add = [&](const auto& bonds) {
          if (grains.is_periodic())
            add_pair_forces<true>(law, bonds, grains, step, memory_.pairs, loads, losses);
          else
            add_pair_forces<false>(law, bonds, grains, step, memory_.pairs, loads, losses);
        };
        if (cohesion_)
          add(Cement{*cohesion_});
        else
          add(NoBonds{});
        add_wall_forces(law, wall_friction_, grains, step, memory_.at_walls, loads, on_wall, losses);
      },
      law_);
  return losses;
}

void Contacts::set_reach(double reach, const Grains& grains) {
  if (reach == reach_)
    return;
  reach_ = reach;
  renew(grains);
}

void Contacts::renew_if_moved(const Grains& grains, double step) {
  double fastest = 0;
  for (const Velocity& velocity : grains.velocity)
    fastest = std::max(fastest, velocity.translation.squaredNorm());
  fastest = std::sqrt(fastest);
  for (const double velocity : grains.wall_velocity)
    fastest = std::max(fastest, std::abs(velocity));
  memory_.drift += fastest * step;
  if (memory_.drift + memory_.grown <= 0.5 * margin_)
    return;
  double moved = 0;
  for (std::size_t i = 0; i < grains.size(); ++i)
    moved = std::max(moved, (grains.sphere(i).centre - memory_.reference[i]).squaredNorm());
  memory_.drift = std::sqrt(moved);
  const auto walls = wall_positions(grains.packing.box);
  for (std::size_t face = 0; face < walls.size(); ++face)
    memory_.drift = std::max(memory_.drift, std::abs(walls[face] - memory_.reference_walls[face]));
  if (memory_.drift + memory_.grown > 0.45 * margin_)
    renew(grains);
}

void Contacts::renew(const Grains& grains) {
  margin_ = margin_of_radius * mean_radius(grains);
  memory_.pairs = candidate_pairs(grains, margin_, memory_.pairs, reach_);
  memory_.at_walls = candidate_walls(grains, margin_, memory_.at_walls, reach_);
  memory_.reference.resize(grains.size());
  for (std::size_t i = 0; i < grains.size(); ++i)
    memory_.reference[i] = grains.sphere(i).centre;
  memory_.reference_walls = wall_positions(grains.packing.box);
  memory_.drift = memory_.grown = 0;
}

} // namespace pfv
