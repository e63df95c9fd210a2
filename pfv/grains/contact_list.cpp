#include "pfv/grains/contact_list.hpp"

#include <algorithm>
#include <cmath>

namespace pfv {
namespace {

Springs springs_of(const ContactLaw& law, double radius, double overlap) {
  return std::visit([&](const auto& chosen) { return chosen.springs(radius, overlap); }, law);
}

/// Tangent stiffness times a motion of the grains, as a load on them.
std::vector<Load> stiffness_times(const std::vector<Velocity>& motion, const Grains& grains,
                                  const std::vector<Contact>& contacts, const std::vector<Springs>& springs) {
  std::vector<Load> loads(grains.size());
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const auto& [i, j, normal, overlap, radius, shear, cemented] = contacts[c];
    const double arm = grains.sphere(i).radius;
    Vec3 sliding = -motion[i].translation - (arm * motion[i].spin).cross(normal);
    if (j >= 0)
      sliding += motion[j].translation - (grains.sphere(j).radius * motion[j].spin).cross(normal);
    const double closing = sliding.dot(normal);
    const Vec3 force = springs[c].normal * closing * normal + springs[c].tangential * (sliding - closing * normal);
    const Vec3 turn = normal.cross(force);
    loads[i].force -= force;
    loads[i].torque -= arm * turn;
    if (j >= 0) {
      loads[j].force += force;
      loads[j].torque -= grains.sphere(j).radius * turn;
    }
  }
  return loads;
}

double of_lone_contact(const Grains& grains, const ContactLaw& law) {
  double largest = 0;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const double radius = grains.sphere(i).radius;
    const Springs springs = springs_of(law, 0.5 * radius, 0.01 * radius);
    largest = std::max(largest, 2 * std::max(springs.normal, 3.5 * springs.tangential) / grains.mass[i]);
  }
  return largest;
}

} // namespace

std::vector<Contact> contact_list(const Grains& grains, const Contacts& contacts) {
  std::vector<Contact> list;
  const auto& pairs = contacts.memory().pairs;
  const auto& at_walls = contacts.memory().at_walls;
  for (std::size_t i = 0; i < grains.size(); ++i)
    for (int e = pairs.start[i]; e < pairs.start[i + 1]; ++e) {
      const Sphere &a = grains.sphere(i), &b = grains.sphere(pairs.other[e]);
      const Vec3 between = apart(pairs, e, a, b);
      const double distance = between.norm(), reach = a.radius + b.radius;
      if (distance < reach || pairs.bond[e] == Bond::cemented)
        list.push_back({static_cast<int>(i), pairs.other[e], between / distance, reach - distance,
                        a.radius * b.radius / reach, pairs.shear[e], pairs.bond[e] == Bond::cemented});
    }
  for (const Face face : all_faces) {
    const int axis = index(axis_of(face));
    const Box& box = grains.packing.box;
    for (const auto& contact : at_walls.of_face[index(face)]) {
      const Sphere& sphere = grains.sphere(contact.grain);
      const double distance =
          is_upper(face) ? box.upper[axis] - sphere.centre[axis] : sphere.centre[axis] - box.lower[axis];
      if (distance < sphere.radius)
        list.push_back({contact.grain, -1 - index(face), outward_normal(face), sphere.radius - distance, sphere.radius,
                        contact.shear, false});
    }
  }
  return list;
}

double elastic_energy(const Grains& grains, const Contacts& contacts) {
  double energy = 0;
  for (const Contact& contact : contact_list(grains, contacts)) {
    const Springs springs = springs_of(contacts.law(), contact.radius, contact.overlap);
    energy += springs.energy;
    if (springs.tangential > 0)
      energy += 0.5 * contact.shear.squaredNorm() / springs.tangential;
  }
  return energy;
}

Eigen::Matrix3d contact_stress(const Grains& grains, const Contacts& contacts) {
  return contact_stress(grains, contact_list(grains, contacts), contacts.law());
}

Eigen::Matrix3d contact_stress(const Grains& grains, const std::vector<Contact>& contacts, const ContactLaw& law) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Contact& contact : contacts) {
    const Vec3 force = springs_of(law, contact.radius, contact.overlap).force * contact.normal - contact.shear;
    double branch = grains.sphere(contact.first).radius - contact.overlap;
    if (contact.second >= 0)
      branch += grains.sphere(contact.second).radius;
    sum -= branch * contact.normal * force.transpose();
  }
  return sum / grains.packing.box.volume();
}

double largest_square_frequency(const Grains& grains, const Contacts& contacts) {
  constexpr int steps = 60;
  const double alone = of_lone_contact(grains, contacts.law());
  const auto list = contact_list(grains, contacts);
  if (list.empty())
    return alone;
  std::vector<Springs> springs;
  springs.reserve(list.size());
  for (const Contact& contact : list)
    springs.push_back(springs_of(contacts.law(), contact.radius, contact.overlap));

  std::vector<Velocity> mode(grains.size());
  for (std::size_t i = 0; i < mode.size(); ++i) // a start without symmetry, the same each time
    mode[i].translation = {std::sin(1.0 + i), std::sin(2.0 + 3.0 * i), std::sin(3.0 + 7.0 * i)};
  double square = 0;
  for (int step = 0; step < steps; ++step) {
    const auto loads = stiffness_times(mode, grains, list, springs);
    double kinetic = 0, elastic = 0, next = 0;
    for (std::size_t i = 0; i < mode.size(); ++i) {
      const double m = grains.mass[i], inertia = grains.inertia(i);
      kinetic += m * mode[i].translation.squaredNorm() + inertia * mode[i].spin.squaredNorm();
      elastic += mode[i].translation.dot(loads[i].force) + mode[i].spin.dot(loads[i].torque);
      mode[i] = {loads[i].force / m, loads[i].torque / inertia};
      next += m * mode[i].translation.squaredNorm() + inertia * mode[i].spin.squaredNorm();
    }
    square = elastic > 0 ? next / elastic : 0; // of the next mode, and never below the quotient of this one
    if (!(kinetic > 0 && next > 0))
      break;
    for (Velocity& of : mode)
      of = {of.translation / std::sqrt(next), of.spin / std::sqrt(next)};
  }
  return std::max(square, alone);
}

} // namespace pfv
