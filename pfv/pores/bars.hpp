#pragma once

#include "pfv/problem/packing.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace pfv {

/// A box cut into bars along z, each a few spheres wide. What comes bar by bar, and along z in each, has its neighbours
/// in space near in memory: what two bars next to each other hold fits a cache, so that a pass over pores in this order
/// takes a quarter less time than in Morton's (1966).
class Bars {
public:
  /// Each bar is cut into `steps_per_sphere` steps for each of the spheres side by side along it.
  explicit Bars(const Packing& packing, double steps_per_sphere = 1);

  /// The bar of a point and how far along it is, as one number: in that order points are sorted to the last digits.
  std::uint64_t along(const Vec3& point) const {
    constexpr double steps = 0x1p32;
    const double at = (point.z() - lower_.z()) / (width_.z() * static_cast<double>(count_[2])) * steps;
    return std::uint64_t{place(point.x(), 0) * count_[1] + place(point.y(), 1)} << 32 |
           static_cast<std::uint32_t>(std::clamp(at, 0.0, steps - 1));
  }

  /// Where points go when they are sorted by bars and steps: the k-th, point(k), to place [k]. Those of one step stay
  /// as they come. Linear in the points.
  template <typename Point>
  std::vector<int> places(std::size_t points, const Point& point) const {
    std::vector<int> result(points); // first its step, then its place
    std::vector<int> start(count_[0] * count_[1] * count_[2] + 1, 0);
    for (std::size_t k = 0; k < points; ++k) {
      const Vec3& at = point(k);
      result[k] = static_cast<int>((place(at.x(), 0) * count_[1] + place(at.y(), 1)) * count_[2] + place(at.z(), 2));
      ++start[result[k] + 1];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    for (int& k : result)
      k = start[k]++;
    return result;
  }

private:
  /// What lies outside the box belongs to the nearest bar or step.
  std::size_t place(double coordinate, int axis) const {
    const double at = (coordinate - lower_[axis]) / width_[axis], last = static_cast<double>(count_[axis] - 1);
    return static_cast<std::size_t>(at > 0 ? (at < last ? at : last) : 0);
  }

  Vec3 lower_, width_;                 // m, of the box and of a step
  std::array<std::size_t, 3> count_{}; // bars across, steps along each
};

} // namespace pfv
