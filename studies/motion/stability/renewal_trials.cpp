#include "studies/motion/stability/flip_trials.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/simulation/drained_box.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace studies {
namespace {

using namespace pfv;

/// Velocities (m/s) of spheres, all different, and of the walls, at rest.
std::vector<Vec3> wiggle(std::size_t spheres, int number = 1) {
  std::vector<Vec3> velocity(spheres + 6, Vec3::Zero());
  for (std::size_t k = 0; k < spheres; ++k) {
    const double x = number * static_cast<double>(k + 1);
    velocity[k] = {std::sin(x), std::sin(1 + 3 * x), std::sin(2 + 7 * x)};
  }
  return velocity;
}

double difference(const std::vector<Vec3>& before, const std::vector<Vec3>& after) {
  double change = 0, size = 0;
  for (std::size_t k = 0; k < before.size(); ++k) {
    change += (after[k] - before[k]).squaredNorm();
    size += before[k].squaredNorm();
  }
  return std::sqrt(change / size);
}

/// Grains part along their velocities until the pores are renewed, in place or by triangulation.
struct Parting {
  FluidScene scene;
  Packing packing;
  std::vector<Vec3> velocity;
  Clock clock;
  PoreFluid fluid;

  explicit Parting(const Scene& box)
      : scene(*box.fluid), packing(box.packing), velocity(wiggle(packing.spheres.size())),
        fluid(scene, packing, clock) {}

  /// Jump of the forces at the first renewal that makes `count` grow: from those on the pores as they were to those on
  /// renewed ones, all grains in the same places.
  double jump_at(std::size_t PoreFluid::*count) {
    const double stride = 1e-4 * packing.spheres.front().radius;
    for (int n = 0; n < 10000; ++n) {
      const std::vector<Vec3> before = fluid.forces(velocity, {}, 1, clock);
      const std::size_t so_far = fluid.*count;
      fluid.follow(packing, clock);
      if (fluid.*count > so_far)
        return difference(before, fluid.forces(velocity, {}, 1, clock));
      for (std::size_t k = 0; k < packing.spheres.size(); ++k)
        packing.spheres[k].centre += stride * velocity[k];
    }
    throw SolveError("the pores are never renewed");
  }
};

Measured over_renewals(double ratio) {
  Scene box = drained_box(150, ratio, 10);
  box.fluid->tolerance = 1e-10;
  const double in_place = Parting(box).jump_at(&PoreFluid::refreshed), anew = Parting(box).jump_at(&PoreFluid::rebuilt);
  return {{{"rms change, renewed in place", in_place, 0, 0.05}, {"rms change, triangulated anew", anew, 0, 0.05}}};
}

Measured steady_motion(double wobble) {
  const Scene box = drained_box(150, 5, 10);
  Clock clock;
  PoreFluid fluid(*box.fluid, box.packing, clock);
  FluidScene exact = *box.fluid;
  exact.tolerance = 1e-12;
  constexpr int steps = 400;
  double worst = 0;
  for (int n = 1; n <= steps; ++n) {
    std::vector<Vec3> velocity = wiggle(150);
    const std::vector<Vec3> change = wiggle(150, n);
    for (std::size_t k = 0; k < velocity.size(); ++k)
      velocity[k] += wobble * change[k];
    const std::vector<Vec3> forces = fluid.forces(velocity, {}, 1, clock);
    if (n % 40 == 0)
      worst = std::max(worst, difference(PoreFluid(exact, box.packing, clock).forces(velocity, {}, 1, clock), forces));
  }
  return {{{"rms error of the forces", worst, 0, box.fluid->tolerance},
           {"iterations a step", static_cast<double>(fluid.iterations) / steps}}};
}

} // namespace

std::vector<Trial> steady_motion_trials() {
  std::vector<Trial> trials;
  for (const double wobble : {0.0, 1e-12, 1e-9, 1e-7, 1e-5, 1e-3})
    trials.push_back({"Steady motion", fmt::format("velocities change by {:g}", wobble), wobble < 1e-10,
                      [=] { return steady_motion(wobble); }});
  return trials;
}

std::vector<Trial> renewal_trials() {
  std::vector<Trial> trials;
  for (const double ratio : {1.0, 5.0, 20.0})
    trials.push_back({"Renewal of the pores", fmt::format("size ratio {:g}", ratio), ratio == 5,
                      [=] { return over_renewals(ratio); }});
  return trials;
}

} // namespace studies
