#include "pfv/pores/throat_planes.hpp"

#include <algorithm>

namespace pfv {

int gather(const PoreNetwork& network, std::size_t first, FacetBlock& block) {
  const auto& throats = network.throats;
  const int count = static_cast<int>(std::min<std::size_t>(FacetBlock::width, throats.interior - first));
  for (int t = 0; t < count; ++t) {
    const auto& corners = block.vertices[t] = network.corners(first + t);
    for (int c = 0; c < 3; ++c) {
      const Sphere& sphere = network.sites.spheres[corners[c]];
      block.corners[c].x[t] = sphere.centre.x();
      block.corners[c].y[t] = sphere.centre.y();
      block.corners[c].z[t] = sphere.centre.z();
      block.corners[c].radius[t] = sphere.radius;
    }
  }
  return count;
}

void visit_planes(const PoreNetwork& network, const std::function<void(std::size_t, const ThroatPlane&)>& visit) {
  const auto& throats = network.throats;
  FacetBlock block{};
  for (std::size_t first = 0; first < throats.interior; first += FacetBlock::width) {
    const int count = gather(network, first, block);
    block.measure();
    for (int t = 0; t < count; ++t) {
      if (block.is_crowded(t))
        visit(first + t, measure_plane(network.walls, network.sites.spheres, block.vertices[t]));
      else
        visit(first + t, {{block.normal[0][t], block.normal[1][t], block.normal[2][t]},
                          block.area[t],
                          {block.sector[0][t], block.sector[1][t], block.sector[2][t]},
                          block.fluid_area[t]});
    }
  }
  for (std::size_t t = throats.interior; t < throats.size(); ++t)
    visit(t, measure_plane(network.walls, network.sites.spheres, network.corners(t)));
}

} // namespace pfv
