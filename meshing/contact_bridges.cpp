#include "meshing/contact_bridges.hpp"

#include "meshing/periodic_images.hpp"
#include "pfv/problem/face.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace meshing {

namespace {

/// Where a bridge begins, in units of the sphere's radius from its centre: so deep that its end is inside the sphere,
/// so shallow that the bridges of one sphere keep clear of each other.
constexpr double start = 0.7;

/// Two spheres whose surfaces are nearer than `bridged_gap` and whose common circle, if any, hides inside the bridge.
bool needs_bridge(double distance, double radius_1, double radius_2, double bridge) {
  const double smaller = std::min(radius_1, radius_2);
  const double gap = distance - radius_1 - radius_2;
  if (gap > bridged_gap * smaller || distance <= std::abs(radius_1 - radius_2))
    return false;
  if (gap >= 0)
    return true;
  const double offset = (distance * distance + radius_1 * radius_1 - radius_2 * radius_2) / (2 * distance);
  const bool between_centres = offset > 0 && offset < distance; // not where a small sphere pokes out of a large one
  return between_centres && radius_1 * radius_1 - offset * offset < bridge * bridge;
}

/// One of any two opposite directions: images of a bridge, which begin at either sphere, are then drawn alike.
bool points_backwards(const pfv::Vec3& direction) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(direction[axis]) > 1e-6)
      return direction[axis] < 0;
  return false;
}

} // namespace

std::vector<Bridge> contact_bridges(const pfv::Packing& packing, double bridge_radius,
                                    const pfv::PeriodicAxes& periodic) {
  const auto& spheres = packing.spheres;
  const bool repeats = periodic != pfv::PeriodicAxes{};
  std::vector<Bridge> bridges;
  for (std::size_t i = 0; i < spheres.size(); ++i)
    for (std::size_t j = i + 1; j < spheres.size(); ++j) {
      const double distance = (spheres[j].centre - spheres[i].centre).norm();
      const double radius = bridge_radius * std::min(spheres[i].radius, spheres[j].radius);
      if (!needs_bridge(distance, spheres[i].radius, spheres[j].radius, radius))
        continue;
      const pfv::Vec3 direction = (spheres[j].centre - spheres[i].centre) / distance;
      const pfv::Vec3 contact =
          (spheres[i].centre + spheres[i].radius * direction + spheres[j].centre - spheres[j].radius * direction) / 2;
      if (distance_to_box(packing.box, contact) > radius)
        continue;
      Bridge& bridge = bridges.emplace_back(fmt::format("bridge_{}_{}", i, j),
                                            spheres[i].centre + start * spheres[i].radius * direction,
                                            spheres[j].centre - start * spheres[j].radius * direction, radius);
      if (repeats && points_backwards(direction))
        std::swap(bridge.from, bridge.to);
    }
  for (std::size_t k = 0; k < spheres.size(); ++k)
    for (const pfv::Face face : pfv::all_faces) {
      if (periodic[static_cast<std::size_t>(pfv::index(pfv::axis_of(face)))])
        continue;
      const auto& [centre, r] = spheres[k];
      const pfv::Vec3 normal = pfv::outward_normal(face);
      const pfv::Vec3& corner = pfv::is_upper(face) ? packing.box.upper : packing.box.lower;
      const double distance = normal.dot(corner - centre);
      if (needs_bridge(2 * distance, r, r, bridge_radius * r))
        bridges.push_back({fmt::format("bridge_{}_{}", k, pfv::face_names[pfv::index(face)]),
                           centre + start * r * normal, centre + (distance + r / 2) * normal, bridge_radius * r});
    }
  return bridges;
}

} // namespace meshing
