#include "reference/stokes_fem/bridge_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reference::stokes_fem {

pfv::Vec3 bridge_direction(const Bridge& bridge, const pfv::Packing& packing) {
  if (const auto* face = std::get_if<pfv::Face>(&bridge.other))
    return outward_normal(*face);
  const pfv::Vec3 other = packing.spheres[std::get<std::size_t>(bridge.other)].centre;
  return (other - packing.spheres[bridge.sphere].centre).normalized();
}

double bridge_section(const Bridge& bridge, const pfv::Packing& packing, double bridge_radius,
                      const pfv::PeriodicAxes& periodic) {
  const pfv::Sphere& sphere = packing.spheres[bridge.sphere];
  const auto* other = std::get_if<std::size_t>(&bridge.other);
  const double smaller = other ? std::min(sphere.radius, packing.spheres[*other].radius) : sphere.radius;
  const pfv::Vec3 direction = bridge_direction(bridge, packing);
  double area = std::numbers::pi * bridge_radius * bridge_radius * smaller * smaller;
  for (const pfv::Face face : pfv::all_faces) {
    const int axis = index(axis_of(face));
    if (periodic[static_cast<std::size_t>(axis)])
      continue;
    const double plane = (is_upper(face) ? packing.box.upper : packing.box.lower)[axis];
    if (std::abs(sphere.centre[axis] - plane) < 1e-6 * smaller && std::abs(direction[axis]) < 1e-6)
      area /= 2;
  }
  return area;
}

} // namespace reference::stokes_fem
