#pragma once

#include "pfv/problem/face.hpp"
#include "pfv/problem/generate.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace pfv::testing {

/// Packings of the kinds that break pore networks, one after the other from a seed: 1 to 300 spheres of size ratio 1 to
/// 30, thrown anywhere so that they overlap, hide one another, touch and cross walls, or on lattices, exact or moved by
/// a jitter of 1e-15 to 1e-3 of a cell; some all in one plane or line, some nearly identical in pairs.
class HardPackings {
public:
  explicit HardPackings(std::uint64_t seed) : random_(seed) {}

  Packing next() {
    Packing packing;
    const double size = std::pow(10, uniform(-6, 3));
    packing.box.lower = size * Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    packing.box.upper = packing.box.lower + size * Vec3(uniform(.3, 1), uniform(.3, 1), uniform(.3, 1));
    switch (choose(6)) {
    case 0:
      on_lattice(packing);
      break;
    case 1:
      thrown(packing, uniform(.8, 1.3)); // some overlap
      flatten(packing);
      break;
    case 2:
      thrown(packing, uniform(.8, 1.5));
      pair_up(packing);
      break;
    case 3:
      thrown(packing, uniform(.05, .5));
      against_walls(packing);
      break;
    default:
      thrown(packing, uniform(.1, 1.1));
    }
    for (auto& sphere : packing.spheres)
      sphere.centre = sphere.centre.cwiseMax(packing.box.lower).cwiseMin(packing.box.upper);
    return packing;
  }

  PeriodicAxes periodic() {
    PeriodicAxes axes{};
    if (choose(3) == 0)
      for (bool& axis : axes)
        axis = choose(2) == 0;
    return axes;
  }

private:
  double uniform(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  int choose(int count) { return std::uniform_int_distribution(0, count - 1)(random_); }

  Vec3 anywhere(const Box& box) {
    return box.lower + Vec3(uniform(0, 1), uniform(0, 1), uniform(0, 1)).cwiseProduct(box.size());
  }

  /// Radii of any ratio up to 30 whose volumes make up `fraction` of the box.
  void thrown(Packing& packing, double fraction) {
    const int count = static_cast<int>(std::pow(300, uniform(0, 1)));
    const double ratio = choose(2) == 0 ? 1 : std::pow(30, uniform(0, 1));
    double cubes = 0;
    for (int s = 0; s < count; ++s) {
      packing.spheres.push_back({anywhere(packing.box), std::pow(ratio, uniform(0, 1))});
      cubes += std::pow(packing.spheres.back().radius, 3);
    }
    const double scale = std::cbrt(fraction * packing.box.volume() / (4.19 * cubes));
    const double largest = .45 * packing.box.size().minCoeff();
    for (auto& sphere : packing.spheres)
      sphere.radius = std::min(scale * sphere.radius, largest);
    if (choose(2) == 0)
      spread(packing);
  }

  /// Takes out spheres whose centre lies in another, so that most of the rest overlap little.
  static void spread(Packing& packing) {
    std::vector<Sphere> kept;
    for (const auto& sphere : packing.spheres)
      if (std::ranges::none_of(kept, [&](const Sphere& other) {
            return (other.centre - sphere.centre).norm() < .9 * (other.radius + sphere.radius);
          }))
        kept.push_back(sphere);
    packing.spheres = kept;
  }

  void flatten(Packing& packing) {
    const int axis = choose(3), other = choose(3);
    const double at = uniform(.1, .9);
    for (auto& sphere : packing.spheres)
      for (const int a : {axis, other})
        sphere.centre[a] = packing.box.lower[a] + at * packing.box.size()[a];
    spread(packing);
  }

  void pair_up(Packing& packing) {
    const double apart = std::pow(10, uniform(-16, -2)) * packing.box.size().minCoeff();
    const std::size_t count = packing.spheres.size();
    for (std::size_t s = 0; s < count; s += 3) {
      Sphere twin = packing.spheres[s];
      twin.centre += apart * Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
      packing.spheres.push_back(twin);
    }
  }

  void against_walls(Packing& packing) {
    for (auto& sphere : packing.spheres)
      for (int axis = 0; axis < 3; ++axis) {
        const double reach = choose(2) * sphere.radius; // touching, or centred on the wall
        if (choose(3) == 0)
          sphere.centre[axis] = choose(2) == 0 ? packing.box.lower[axis] + reach : packing.box.upper[axis] - reach;
      }
    spread(packing);
  }

  void on_lattice(Packing& packing) {
    const auto lattice = static_cast<Lattice>(choose(3));
    packing = lattice_packing(lattice, uniform(.1, 1) * touching_solid_fraction(lattice), 1 + choose(4),
                              packing.box.size().x());
    const double cell = packing.spheres.front().radius;
    const double jitter = choose(3) == 0 ? 0 : std::pow(10, uniform(-15, -3)) * cell;
    for (auto& sphere : packing.spheres) {
      sphere.centre += jitter * Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
      if (choose(4) == 0)
        sphere.radius *= uniform(1, 1.1);
    }
  }

  std::mt19937_64 random_;
};

} // namespace pfv::testing
