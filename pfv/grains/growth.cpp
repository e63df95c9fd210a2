#include "pfv/grains/growth.hpp"

#include <algorithm>

namespace pfv {

double mean_stress(const Eigen::Matrix3d& stress) {
  return -stress.trace() / 3;
}

double growth_rate(const Growth& growth, double mean_stress) {
  return growth.rate * std::clamp(1 - mean_stress / growth.stress, -1.0, 1.0);
}

void grow(Grains& grains, double factor, double density) {
  if (grains.first_radius.empty())
    for (const Sphere& sphere : grains.packing.spheres)
      grains.first_radius.push_back(sphere.radius);
  grains.grown *= factor;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    Sphere& sphere = grains.packing.spheres[i];
    sphere.radius = grains.grown * grains.first_radius[i];
    grains.mass[i] = density * volume(sphere);
  }
  require_wide(grains.packing, grains.periodic);
}

double growth_work(const Grains& grains, const std::vector<Contact>& contacts, const ContactLaw& law, double factor) {
  const auto stored = [&](const Contact& contact, double radius, double overlap) {
    const Springs springs = std::visit([&](const auto& is) { return is.springs(radius, overlap); }, law);
    return springs.energy + (springs.tangential > 0 ? 0.5 * contact.shear.squaredNorm() / springs.tangential : 0);
  };
  double work = 0;
  for (const Contact& contact : contacts) {
    double both = grains.sphere(contact.first).radius;
    if (contact.second >= 0)
      both += grains.sphere(contact.second).radius;
    work += stored(contact, factor * contact.radius, contact.overlap + (factor - 1) * both) -
            stored(contact, contact.radius, contact.overlap);
  }
  const double square = factor * factor, cube = factor * square;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const Velocity& velocity = grains.velocity[i];
    work += 0.5 * (cube - 1) * grains.mass[i] * velocity.translation.squaredNorm() +
            0.5 * (cube * square - 1) * grains.inertia(i) * velocity.spin.squaredNorm();
  }
  return work;
}

} // namespace pfv
