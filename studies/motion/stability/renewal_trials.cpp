#include "studies/motion/stability/flip_trials.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/simulation/drained_box.hpp"

#include <cmath>
#include <fmt/format.h>

namespace studies {
namespace {

using namespace pfv;

std::vector<Vec3> wiggle(std::size_t spheres) {
  std::vector<Vec3> velocity(spheres + 6, Vec3::Zero());
  for (std::size_t k = 0; k < spheres; ++k)
    velocity[k] = {std::sin(1 + 1.0 * k), std::sin(2 + 3.0 * k), std::sin(3 + 7.0 * k)};
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

} // namespace

std::vector<Trial> renewal_trials() {
  std::vector<Trial> trials;
  for (const double ratio : {1.0, 5.0, 20.0})
    trials.push_back({"Renewal of the pores", fmt::format("size ratio {:g}", ratio), ratio == 5,
                      [=] { return over_renewals(ratio); }});
  return trials;
}

} // namespace studies
