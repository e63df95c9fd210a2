#include "meshing/exact_void.hpp"

#include "meshing/disc_union.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numeric>
#include <vector>

namespace meshing {

namespace {

using Spheres = std::vector<pfv::Sphere>;

/// Groups that do not overlap each other, so that each is measured by itself.
std::vector<Spheres> overlapping_groups(const Spheres& spheres) {
  std::vector<std::size_t> group(spheres.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (group[i] != i)
      i = group[i];
    return i;
  };
  for (std::size_t i = 0; i < spheres.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double reach = spheres[i].radius + spheres[j].radius;
      if ((spheres[i].centre - spheres[j].centre).squaredNorm() < reach * reach * (1 - 1e-12))
        group[root(i)] = root(j);
    }
  std::vector<Spheres> groups(spheres.size());
  for (std::size_t i = 0; i < spheres.size(); ++i)
    groups[root(i)].push_back(spheres[i]);
  std::erase_if(groups, [](const Spheres& members) { return members.empty(); });
  return groups;
}

/// Where along x a slice of one sphere appears, meets an edge of the box or swallows a corner.
void add_breaks(const pfv::Sphere& sphere, const pfv::Box& box, std::vector<double>& breaks) {
  const auto& [c, r] = sphere;
  const auto add = [&](double squared) {
    if (squared < 0)
      return;
    breaks.push_back(c.x() - std::sqrt(squared));
    breaks.push_back(c.x() + std::sqrt(squared));
  };
  add(r * r);
  for (const double y : {box.lower.y(), box.upper.y()})
    add(r * r - std::pow(y - c.y(), 2));
  for (const double z : {box.lower.z(), box.upper.z()}) {
    add(r * r - std::pow(z - c.z(), 2));
    for (const double y : {box.lower.y(), box.upper.y()})
      add(r * r - std::pow(y - c.y(), 2) - std::pow(z - c.z(), 2));
  }
}

DiscUnion slice(const Spheres& spheres, const pfv::Box& box, double x) {
  std::vector<Disc> discs;
  for (const auto& [centre, radius] : spheres)
    if (const double squared = radius * radius - std::pow(x - centre.x(), 2); squared > 0)
      // A band dx of a sphere has area r dtheta dx wherever it is cut (Archimedes).
      discs.push_back({centre.y() - box.lower.y(), centre.z() - box.lower.z(), std::sqrt(squared), radius});
  return disc_union(discs, box.size().y(), box.size().z());
}

/// Solid volume and wetted surface of spheres inside the box.
VoidMeasure measure(const Spheres& spheres, const pfv::Box& box) {
  std::vector<double> breaks{box.lower.x(), box.upper.x()};
  for (const pfv::Sphere& sphere : spheres)
    add_breaks(sphere, box, breaks);
  for (double& x : breaks)
    x = std::clamp(x, box.lower.x(), box.upper.x());
  std::ranges::sort(breaks);

  using Quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;
  constexpr unsigned depth = 10;
  constexpr double tolerance = 1e-11;
  VoidMeasure total{0, 0};
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    const double begin = breaks[i - 1];
    const double width = breaks[i] - begin;
    if (width <= 1e-14 * box.size().x())
      continue;
    // Slices start and end like powers 1/2 or 3/2: smooth in u when x runs like u^2 there.
    const auto integral = [&](auto value) {
      return width * Quadrature::integrate(
                         [&](double u) { return 6 * u * (1 - u) * value(begin + width * u * u * (3 - 2 * u)); }, 0.0,
                         1.0, depth, tolerance);
    };
    total.volume += integral([&](double x) { return slice(spheres, box, x).area; });
    total.surface += integral([&](double x) { return slice(spheres, box, x).arcs; });
  }
  return total;
}

} // namespace

VoidMeasure exact_void(const pfv::Packing& packing) {
  VoidMeasure result{packing.box.volume(), 0};
  for (const Spheres& group : overlapping_groups(packing.spheres)) {
    const auto [volume, surface] = measure(group, packing.box);
    result.volume -= volume;
    result.surface += surface;
  }
  return result;
}

} // namespace meshing
