#include "pfv/pores/sites.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pfv {
namespace {

/// Where a point comes in the order of sites_of: its bar, then its place along it.
class BarOrder {
public:
  explicit BarOrder(const Packing& packing) : lower_(packing.box.lower), length_(packing.box.size().z()) {
    const Vec3 size = packing.box.size();
    const double spacing = std::cbrt(size.prod() / static_cast<double>(packing.spheres.size()));
    for (int axis = 0; axis < 2; ++axis)
      bars_[axis] = std::clamp(std::floor(size[axis] / (spheres_across_a_bar * spacing)), 1.0, most_bars);
    width_ = {size.x() / bars_[0], size.y() / bars_[1]};
  }

  std::uint64_t operator()(const Vec3& point) const {
    const Vec3 from = point - lower_;
    const auto x = clamped(from.x() / width_[0], bars_[0]), y = clamped(from.y() / width_[1], bars_[1]);
    const auto bar = x * static_cast<std::uint64_t>(bars_[1]) + y;
    return bar << 32 | clamped(from.z() / length_ * steps_along_a_bar, steps_along_a_bar);
  }

private:
  static constexpr double spheres_across_a_bar = 2.75; // measured: 1.5 and 4.5 are slower
  static constexpr double most_bars = 1 << 15, steps_along_a_bar = 1LL << 32;

  static std::uint64_t clamped(double place, double count) {
    return static_cast<std::uint64_t>(std::clamp(place, 0.0, count - 1));
  }

  Vec3 lower_;
  double length_;
  std::array<double, 2> bars_{}, width_{};
};

} // namespace

Sites sites_of(const Packing& packing) {
  std::vector<std::pair<std::uint64_t, int>> order;
  order.reserve(packing.spheres.size());
  const BarOrder place(packing);
  for (std::size_t k = 0; k < packing.spheres.size(); ++k)
    order.emplace_back(place(packing.spheres[k].centre), static_cast<int>(k));
  std::ranges::sort(order);
  Sites sites;
  sites.spheres.reserve(order.size());
  sites.number.reserve(order.size());
  for (const auto& [code, k] : order) {
    sites.spheres.push_back(packing.spheres[k]);
    sites.number.push_back(k);
  }
  return sites;
}

void move_sites(Sites& sites, const Packing& packing) {
  const Vec3 size = packing.box.size();
  for (std::size_t s = 0; s < sites.size(); ++s) {
    sites.spheres[s] = packing.spheres[sites.number[s]];
    if (!sites.shift.empty())
      for (int axis = 0; axis < 3; ++axis)
        sites.spheres[s].centre[axis] += sites.shift[s][axis] * size[axis];
  }
}

} // namespace pfv
