#include "reference/pore_volumes/repeated_step.hpp"

#include "pfv/problem/error.hpp"

#include <cmath>
#include <random>

namespace reference {

namespace {

constexpr double step = 1e-5; // of the radius: what grains move in a time step of a slow deformation

// Towards the middle of the box, so that no centre leaves it.
pfv::Packing moved(pfv::Packing packing) {
  std::mt19937 random(1);
  const pfv::Vec3 middle = (packing.box.lower + packing.box.upper) / 2;
  for (auto& [centre, radius] : packing.spheres)
    for (int i = 0; i < 3; ++i) {
      const double part = static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
      centre[i] += std::copysign(part * step * radius, middle[i] - centre[i]);
    }
  return packing;
}

double whole(const pfv::Clock& clock) {
  double sum = 0;
  for (const pfv::Stage& stage : clock.stages())
    sum += stage.cpu_seconds;
  return sum;
}

} // namespace

std::vector<pfv::Stage> repeated_step(pfv::FollowedFlow& flow, const pfv::Packing& packing) {
  try {
    pfv::Clock away, back;
    flow.follow(moved(packing), away);
    flow.follow(packing, back);
    return whole(away) < whole(back) ? away.stages() : back.stages();
  } catch (const pfv::SolveError&) {
    return {};
  }
}

} // namespace reference
