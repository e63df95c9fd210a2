#include "pfv/grains/grains.hpp"

#include "pfv/pores/sites.hpp"

namespace pfv {

Grains grains_of(const Packing& packing, double density) {
  Grains grains;
  Sites sites = sites_of(packing);
  grains.packing = {packing.box, std::move(sites.spheres)};
  grains.number = std::move(sites.number);
  grains.velocity.resize(grains.number.size());
  grains.mass.reserve(grains.number.size());
  for (const Sphere& sphere : grains.packing.spheres)
    grains.mass.push_back(density * volume(sphere));
  return grains;
}

Packing packing_of(const Grains& grains) {
  Packing packing = grains.packing;
  for (std::size_t i = 0; i < grains.size(); ++i)
    packing.spheres[grains.number[i]] = grains.sphere(i);
  return packing;
}

} // namespace pfv
