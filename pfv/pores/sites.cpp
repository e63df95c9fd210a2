#include "pfv/pores/sites.hpp"

#include <algorithm>
#include <utility>

namespace pfv {
namespace {

/// Every third bit of a number below 2^21.
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | bits << 32) & 0x1f00000000ffff;
  bits = (bits | bits << 16) & 0x1f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  return (bits | bits << 2) & 0x1249249249249249;
}

std::uint64_t morton_code(const Vec3& point, const Box& box) {
  constexpr double cells = 1 << 21;
  const double side = box.size().maxCoeff();
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double along = (point[axis] - box.lower[axis]) / side;
    code |= spread(static_cast<std::uint64_t>(std::clamp(along * cells, 0.0, cells - 1))) << axis;
  }
  return code;
}

} // namespace

Sites sites_of(const Packing& packing) {
  std::vector<std::pair<std::uint64_t, int>> order;
  order.reserve(packing.spheres.size());
  for (std::size_t k = 0; k < packing.spheres.size(); ++k)
    order.emplace_back(morton_code(packing.spheres[k].centre, packing.box), static_cast<int>(k));
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
