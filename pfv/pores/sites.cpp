#include "pfv/pores/sites.hpp"

#include "pfv/pores/bars.hpp"

namespace pfv {

Sites sites_of(const Packing& packing) {
  constexpr double steps_per_sphere = 4;
  const auto place = Bars(packing, steps_per_sphere).places(packing.spheres.size(), [&](std::size_t k) -> const Vec3& {
    return packing.spheres[k].centre;
  });
  Sites sites;
  sites.spheres.resize(place.size());
  sites.number.resize(place.size());
  for (std::size_t k = 0; k < place.size(); ++k) {
    sites.spheres[place[k]] = packing.spheres[k];
    sites.number[place[k]] = static_cast<int>(k);
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
