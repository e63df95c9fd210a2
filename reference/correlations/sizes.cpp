#include "reference/correlations/sizes.hpp"

#include "reference/correlations/drag.hpp"

#include <algorithm>
#include <cmath>

namespace reference {

double sauter_diameter(std::span<const pfv::Sphere> spheres) {
  double squares = 0, cubes = 0;
  for (const pfv::Sphere& sphere : spheres) {
    squares += sphere.radius * sphere.radius;
    cubes += sphere.radius * sphere.radius * sphere.radius;
  }
  return 2 * cubes / squares;
}

bool equal_spheres(std::span<const pfv::Sphere> spheres) {
  const auto [least, most] = std::ranges::minmax(spheres, {}, &pfv::Sphere::radius);
  return most.radius - least.radius <= 1e-9 * most.radius;
}

double beetstra_packing_factor(double solid_fraction, std::span<const pfv::Sphere> spheres) {
  if (equal_spheres(spheres))
    return 1;
  const double sauter = sauter_diameter(spheres);
  double forces = 0, alike = 0;
  for (const pfv::Sphere& sphere : spheres) {
    const double size = 2 * sphere.radius / sauter;
    forces += size * beetstra_size_factor(solid_fraction, size);
    alike += size * size * size; // as many spheres of the Sauter diameter hold as much solid
  }
  return forces / alike;
}

} // namespace reference
