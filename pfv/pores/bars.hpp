#pragma once

#include "pfv/problem/packing.hpp"

#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace pfv {

/// A box cut into bars along z, each a few spheres wide. What comes bar by bar, and along z in each, has its neighbours
/// in space near in memory: what two bars next to each other hold fits a cache, so that a pass over pores in this order
/// takes a quarter less time than in Morton's (1966).
class Bars {
public:
  /// Each bar is cut into `steps_per_sphere` steps for each of the spheres side by side along it.
  Bars(const Packing& packing, double steps_per_sphere);

  /// Where points go when they are sorted by bars and steps: the k-th, point(k), to place [k]. Those of one step stay
  /// as they come. Linear in the points.
  template <typename Point>
  std::vector<int> places(std::size_t points, const Point& point) const {
    std::vector<int> place(points); // first its step, then its place
    std::vector<int> start(count_[0] * count_[1] * count_[2] + 1, 0);
    for (std::size_t k = 0; k < points; ++k) {
      place[k] = static_cast<int>(step(point(k)));
      ++start[place[k] + 1];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    for (int& k : place)
      k = start[k]++;
    return place;
  }

private:
  /// What lies outside the box belongs to the nearest step.
  std::size_t step(const Vec3& point) const {
    std::size_t result = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double at = (point[axis] - lower_[axis]) / width_[axis], last = static_cast<double>(count_[axis] - 1);
      result = result * count_[axis] + static_cast<std::size_t>(at > 0 ? (at < last ? at : last) : 0);
    }
    return result;
  }

  Vec3 lower_, width_;                 // m, of the box and of a step
  std::array<std::size_t, 3> count_{}; // bars across, steps along each
};

} // namespace pfv
