#include "pfv/pores/sites.hpp"

#include "pfv/pores/bars.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pfv {

Sites sites_of(const Packing& packing) {
  std::vector<std::pair<std::uint64_t, int>> order;
  order.reserve(packing.spheres.size());
  const Bars bars(packing);
  for (std::size_t k = 0; k < packing.spheres.size(); ++k)
    order.emplace_back(bars.along(packing.spheres[k].centre), static_cast<int>(k));
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
