#include "pfv/problem/packing.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "pfv/problem/validate.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <numeric>
#include <ostream>

namespace pfv {

namespace {

std::string where_box(const PackingOrigin& origin) {
  return origin.box.empty() ? "box" : origin.box;
}

void validate(const Box& box, const PackingOrigin& origin) {
  if (!box.lower.allFinite() || !box.upper.allFinite() || !(box.lower.array() < box.upper.array()).all())
    throw InputError(fmt::format("{}: box \"{} {}\" must be six finite numbers, the lower corner below the upper in x, "
                                 "y and z (m)",
                                 where_box(origin), shortest(box.lower), shortest(box.upper)));
  if (!std::isnormal(box.volume()))
    throw InputError(fmt::format("{}: box \"{} {}\" must have a volume that a double can hold", where_box(origin),
                                 shortest(box.lower), shortest(box.upper)));
}

void validate(const Sphere& sphere, const Box& box, const PackingOrigin& origin, std::size_t number) {
  if (!sphere.centre.allFinite() || !std::isfinite(sphere.radius) || !(sphere.radius > 0))
    validate(sphere, place_of_sphere(origin, number));
  if ((sphere.centre.array() < box.lower.array()).any() || (sphere.centre.array() > box.upper.array()).any())
    throw InputError(fmt::format("{}: centre \"{}\" must lie in the box \"{} {}\" (m)", place_of_sphere(origin, number),
                                 shortest(sphere.centre), shortest(box.lower), shortest(box.upper)));
}

bool lexicographic(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

void validate_distinct(const Packing& packing, const PackingOrigin& origin, const PeriodicAxes& periodic) {
  const auto& [box, spheres] = packing;
  const auto centre = [&](std::size_t sphere) {
    Vec3 at = spheres[sphere].centre;
    for (int axis = 0; axis < 3; ++axis)
      if (periodic[axis] && at[axis] == box.upper[axis])
        at[axis] = box.lower[axis];
    return at;
  };
  std::vector<std::size_t> order(spheres.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, lexicographic, centre);
  const auto twin = std::ranges::adjacent_find(order, {}, centre);
  if (twin == order.end())
    return;
  const Vec3 &one = spheres[twin[0]].centre, &other = spheres[twin[1]].centre;
  throw InputError(fmt::format("{}: centre \"{}\" must differ from that of every other sphere; {} has {}",
                               place_of_sphere(origin, twin[1]), shortest(other), place_of_sphere(origin, twin[0]),
                               one == other ? "it too" : "its periodic image " + shortest(one)));
}

} // namespace

std::string place_of_sphere(const PackingOrigin& origin, std::size_t sphere) {
  if (origin.file.empty())
    return fmt::format("spheres[{}]", sphere);
  if (origin.sphere_lines.empty())
    return fmt::format("{}: point {}", origin.file, sphere);
  return fmt::format("{}:{}", origin.file, origin.sphere_lines.at(sphere));
}

void validate(const Sphere& sphere, const std::string& place) {
  if (!sphere.centre.allFinite())
    throw InputError(fmt::format("{}: centre \"{}\" must be three finite numbers (m)", place, shortest(sphere.centre)));
  if (!std::isfinite(sphere.radius) || !(sphere.radius > 0))
    throw InputError(fmt::format("{}: radius \"{}\" must be a positive number (m)", place, shortest(sphere.radius)));
}

void validate(const Packing& packing, const PackingOrigin& origin, const PeriodicAxes& periodic) {
  validate(packing.box, origin);
  if (packing.spheres.empty())
    throw InputError(fmt::format("{}: packing has \"0\" spheres and needs at least one", where_box(origin)));
  for (std::size_t i = 0; i < packing.spheres.size(); ++i)
    validate(packing.spheres[i], packing.box, origin, i);
  validate_distinct(packing, origin, periodic);
}

void validate(const Packing& packing, const PeriodicAxes& periodic) {
  validate(packing, {}, periodic);
}

void write_packing(const Packing& packing, std::ostream& out) {
  out << "# box " << shortest(packing.box.lower) << ' ' << shortest(packing.box.upper) << '\n';
  for (const auto& [centre, radius] : packing.spheres)
    out << shortest(centre) << ' ' << shortest(radius) << '\n';
}

double solid_fraction(const Packing& packing) {
  double cubes = 0;
  for (const Sphere& sphere : packing.spheres)
    cubes += std::pow(sphere.radius, 3);
  return 4 * std::numbers::pi / 3 * cubes / packing.box.volume();
}

} // namespace pfv
