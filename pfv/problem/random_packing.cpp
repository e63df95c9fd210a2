#include "pfv/problem/close_pairs.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "pfv/problem/soft_spheres.hpp"
#include "pfv/problem/text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <random>

namespace pfv {

namespace {

void validate(const RandomPacking& parameters) {
  const auto& [spheres, fraction, ratio, seed, size, periodic] = parameters;
  if (spheres < 1)
    throw InputError(fmt::format("spheres \"{}\" must be 1 or more", spheres));
  if (!(fraction > 0 && fraction <= 0.6))
    throw InputError(fmt::format("solid_fraction \"{}\" must be above 0 and at most 0.6", shortest(fraction)));
  if (!(std::isfinite(ratio) && ratio >= 1))
    throw InputError(fmt::format("radius_ratio \"{}\" must be a number, 1 or more", shortest(ratio)));
  if (!(std::isfinite(size) && size > 0))
    throw InputError(fmt::format("size \"{}\" must be a positive number (m)", shortest(size)));
}

/// By Newton's steps from above: std::cbrt rounds differently from library to library.
double cube_root(double value) {
  double root = std::max(1.0, value);
  for (double next = root;; root = next) {
    next = root - (root - value / (root * root)) / 3;
    if (!(next < root))
      return root;
  }
}

/// Evenly spaced from the largest to the smallest, of the volume asked in the unit cube.
std::vector<double> radii_of(const RandomPacking& parameters) {
  std::vector<double> radii(parameters.spheres, 1.0);
  for (int s = 0; s + 1 < parameters.spheres; ++s)
    radii[s] += (parameters.radius_ratio - 1) * (1 - static_cast<double>(s) / (parameters.spheres - 1));
  double cubes = 0;
  for (const double radius : radii)
    cubes += radius * radius * radius;
  const double scale = cube_root(parameters.solid_fraction / (4 * std::numbers::pi / 3 * cubes));
  for (double& radius : radii)
    radius *= scale;
  return radii;
}

struct Arrangement {
  std::vector<Vec3> centres;
  double room; // by what factor the radii could grow before something overlaps
};

/// Spheres thrown at random and pushed apart with their radii enlarged, so that they end a little apart rather than in
/// contact: by 1 % where there is room for it, by less where there is not.
Arrangement arrange(const std::vector<double>& radii, std::vector<Vec3> centres, const PeriodicAxes& periodic) {
  Arrangement best{{}, 0};
  for (const double enlarged : {1 + 1e-2, 1 + 1e-3, 1 + 1e-4}) {
    SoftSpheres soft{std::move(centres), radii, periodic};
    for (double& radius : soft.radii)
      radius *= enlarged;
    Relaxed relaxed = relax(soft, 0.1 * (enlarged - 1), 5000);
    const double room = enlarged * (1 - relaxed.worst_overlap);
    centres = relaxed.centres;
    if (room > best.room)
      best = {std::move(relaxed.centres), room};
    if (best.room > 1 + 1e-5)
      break;
  }
  return best;
}

bool overlaps(const Packing& packing, const std::vector<ClosePair>& pairs, const PeriodicAxes& periodic) {
  const auto& [box, spheres] = packing;
  const double size = box.upper.x();
  const auto out = [&](const Sphere& s) {
    for (int axis = 0; axis < 3; ++axis) {
      const double from_lower = s.centre[axis] - s.radius, to_upper = s.centre[axis] + s.radius;
      if (periodic[axis] ? 2 * s.radius > size : from_lower < box.lower[axis] || to_upper > box.upper[axis])
        return true;
    }
    return false;
  };
  const auto too_close = [&](const ClosePair& pair) {
    const Sphere &a = spheres[pair.first], &b = spheres[pair.second];
    return nearest_image(a.centre - b.centre, periodic, size).norm() < a.radius + b.radius;
  };
  return std::ranges::any_of(spheres, out) || std::ranges::any_of(pairs, too_close);
}

} // namespace

Packing random_packing(const RandomPacking& parameters) {
  validate(parameters);
  const std::vector<double> radii = radii_of(parameters);
  std::mt19937_64 generator(parameters.seed);
  // The distributions of the standard library differ from one library to another.
  const auto uniform = [&] { return static_cast<double>(generator() >> 11) * 0x1p-53; };

  // A small packing jams or not by luck, a large one by its solid fraction.
  const int attempts = std::clamp(40'000 / parameters.spheres, 2, 1'000);
  const bool has_images = std::ranges::find(parameters.periodic, true) != parameters.periodic.end();
  const double room_for_image = has_images ? 0.5 / radii.front() : std::numeric_limits<double>::infinity();
  double most_room = 0;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    std::vector<Vec3> thrown(radii.size());
    for (Vec3& centre : thrown)
      for (double& coordinate : centre)
        coordinate = uniform();
    const auto [centres, room_for_others] = arrange(radii, std::move(thrown), parameters.periodic);
    const double room = std::min(room_for_others, room_for_image);
    most_room = std::max(most_room, room);
    if (room <= 1)
      continue;
    Packing packing{{Vec3::Zero(), Vec3::Constant(parameters.size)}, {}};
    for (std::size_t s = 0; s < radii.size(); ++s)
      packing.spheres.push_back({parameters.size * centres[s], parameters.size * radii[s]});
    const auto pairs = close_pairs(centres, radii, 1e-6 * radii.front(), parameters.periodic);
    if (!overlaps(packing, pairs, parameters.periodic))
      return packing;
  }
  throw SolveError(fmt::format("solid_fraction \"{}\" was not reached by \"{}\" spheres: the search jams at {:.4f}",
                               shortest(parameters.solid_fraction), parameters.spheres,
                               parameters.solid_fraction * most_room * most_room * most_room));
}

} // namespace pfv
