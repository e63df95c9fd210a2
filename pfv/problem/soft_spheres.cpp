#include "pfv/problem/soft_spheres.hpp"

#include "pfv/problem/close_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace pfv {

namespace {

struct Pushes {
  std::vector<Vec3> forces;
  double worst_overlap;  // relative
  double sum_of_squares; // of the single pushes, to tell balance from rest
};

/// The push of every overlap, stiffness 1.
class Overlaps {
public:
  explicit Overlaps(const SoftSpheres& spheres)
      : radii_(spheres.radii), periodic_(spheres.periodic), skin_(0.3 * *std::ranges::max_element(radii_)) {
    pushes_.forces.resize(radii_.size());
  }

  const Pushes& at(const std::vector<Vec3>& centres) {
    if (has_moved(centres)) {
      listed_at_ = centres;
      pairs_ = close_pairs(centres, radii_, skin_, periodic_);
    }
    std::ranges::fill(pushes_.forces, Vec3::Zero());
    pushes_.worst_overlap = pushes_.sum_of_squares = 0;
    for (const auto& [a, b] : pairs_)
      push_apart(centres, a, b);
    for (std::size_t s = 0; s < radii_.size(); ++s)
      push_off_walls(centres[s], s);
    return pushes_;
  }

private:
  bool has_moved(const std::vector<Vec3>& centres) const {
    if (listed_at_.empty())
      return true;
    for (std::size_t s = 0; s < centres.size(); ++s)
      if (const Vec3 moved = centres[s] - listed_at_[s]; dot(moved, moved) > skin_ * skin_ / 4)
        return true;
    return false;
  }

  void push_apart(const std::vector<Vec3>& centres, int a, int b) {
    const double apart = radii_[a] + radii_[b];
    const Vec3 towards_a = nearest_image(centres[a] - centres[b], periodic_);
    const double squared = dot(towards_a, towards_a);
    if (squared >= apart * apart)
      return;
    const double distance = std::sqrt(squared);
    const double overlap = apart - distance;
    note(overlap, apart);
    if (distance == 0) // no direction to push in
      return;
    const Vec3 push = overlap / distance * towards_a;
    pushes_.forces[a] += push;
    pushes_.forces[b] -= push;
  }

  void push_off_walls(const Vec3& centre, std::size_t s) {
    for (int axis = 0; axis < 3; ++axis) {
      if (periodic_[axis])
        continue;
      const double lower = radii_[s] - centre[axis];
      const double upper = centre[axis] + radii_[s] - 1;
      if (lower > 0) {
        pushes_.forces[s][axis] += lower;
        note(lower, radii_[s]);
      }
      if (upper > 0) {
        pushes_.forces[s][axis] -= upper;
        note(upper, radii_[s]);
      }
    }
  }

  void note(double overlap, double apart) {
    pushes_.worst_overlap = std::max(pushes_.worst_overlap, overlap / apart);
    pushes_.sum_of_squares += overlap * overlap;
  }

  const std::vector<double>& radii_;
  PeriodicAxes periodic_;
  double skin_;
  std::vector<Vec3> listed_at_;
  std::vector<ClosePair> pairs_;
  Pushes pushes_;
};

double inner_product(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t s = 0; s < a.size(); ++s)
    sum += dot(a[s], b[s]);
  return sum;
}

/// The image of each centre that is in the unit cube.
std::vector<Vec3> in_cube(std::vector<Vec3> centres, const PeriodicAxes& periodic) {
  for (Vec3& centre : centres)
    for (int axis = 0; axis < 3; ++axis)
      if (periodic[axis]) {
        centre[axis] -= std::floor(centre[axis]);
        if (centre[axis] >= 1) // what is a rounding error below zero
          centre[axis] = 0;
      }
  return centres;
}

} // namespace

Relaxed relax(const SoftSpheres& spheres, double tolerance, int most_steps) {
  constexpr double first_mixing = 0.1, longest_step = 0.5;
  constexpr double balance = 1e-4; // of the net to the single pushes: jammed
  Overlaps overlaps(spheres);
  std::vector<Vec3> centres = spheres.centres;
  std::vector<Vec3> velocities(centres.size(), Vec3::Zero());
  double step = 0.1, mixing = first_mixing;
  int steps_downhill = 0;
  for (int n = 0;; ++n) {
    const Pushes& pushes = overlaps.at(centres);
    const double force_squared = inner_product(pushes.forces, pushes.forces);
    if (pushes.worst_overlap <= tolerance || n == most_steps ||
        force_squared < balance * balance * pushes.sum_of_squares)
      return {in_cube(std::move(centres), spheres.periodic), pushes.worst_overlap};
    const double power = inner_product(pushes.forces, velocities);
    if (power < 0) {
      std::ranges::fill(velocities, Vec3::Zero());
      step *= 0.5;
      mixing = first_mixing;
      steps_downhill = 0;
    } else if (++steps_downhill > 5) {
      step = std::min(1.1 * step, longest_step);
      mixing *= 0.99;
    }
    const double along = mixing * std::sqrt(inner_product(velocities, velocities) / force_squared);
    for (std::size_t s = 0; s < centres.size(); ++s) {
      velocities[s] = (1 - mixing) * velocities[s] + (along + step) * pushes.forces[s];
      centres[s] += step * velocities[s];
    }
  }
}

} // namespace pfv
