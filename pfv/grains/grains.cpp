#include "pfv/grains/grains.hpp"

#include "pfv/pores/sites.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace pfv {

void require_wide(const Packing& packing, const PeriodicAxes& periodic, double reach) {
  double largest = 0;
  for (const Sphere& sphere : packing.spheres)
    largest = std::max(largest, sphere.radius);
  const double diameters = 2.2 + reach;
  for (int axis = 0; axis < 3; ++axis)
    if (const double width = packing.box.size()[axis]; periodic[axis] && width < 2 * diameters * largest)
      throw InputError(fmt::format("the box \"{}\" along its periodic axis {} must be at least {} diameters of the "
                                   "largest grain wide, \"{}\"",
                                   shortest(width), axis_names[axis], shortest(diameters),
                                   shortest(2 * diameters * largest)));
}

Grains grains_of(const Packing& packing, double density, const PeriodicAxes& periodic) {
  require_wide(packing, periodic);
  Grains grains;
  grains.periodic = periodic;
  Sites sites = sites_of(packing);
  grains.packing = {packing.box, std::move(sites.spheres)};
  grains.number = std::move(sites.number);
  grains.velocity.resize(grains.number.size());
  grains.mass.reserve(grains.number.size());
  for (const Sphere& sphere : grains.packing.spheres)
    grains.mass.push_back(density * volume(sphere));
  return grains;
}

Vec3 image_offset(const Grains& grains, const Vec3& place, const Vec3& other) {
  Vec3 offset = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis)
    if (grains.periodic[axis]) {
      const double size = grains.packing.box.upper[axis] - grains.packing.box.lower[axis];
      offset[axis] = size * std::round((place[axis] - other[axis]) / size);
    }
  return offset;
}

Vec3 offset_into_box(const Box& box, const PeriodicAxes& periodic, const Vec3& place) {
  Vec3 offset = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis)
    if (periodic[axis]) {
      const double size = box.upper[axis] - box.lower[axis];
      offset[axis] = -size * std::floor((place[axis] - box.lower[axis]) / size);
      if (place[axis] + offset[axis] >= box.upper[axis]) // rounded up
        offset[axis] -= size;
    }
  return offset;
}

Packing packing_of(const Grains& grains) {
  Packing packing = grains.packing;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    Sphere sphere = grains.sphere(i);
    sphere.centre += offset_into_box(grains.packing.box, grains.periodic, sphere.centre);
    packing.spheres[grains.number[i]] = sphere;
  }
  return packing;
}

Packing packing_near(const Grains& grains, const Packing& before) {
  Packing packing = packing_of(grains);
  for (std::size_t k = 0; k < packing.spheres.size(); ++k)
    packing.spheres[k].centre += image_offset(grains, before.spheres[k].centre, packing.spheres[k].centre);
  return packing;
}

} // namespace pfv
