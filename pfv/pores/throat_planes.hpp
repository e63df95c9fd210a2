#pragma once

#include "pfv/pores/facet_block.hpp"
#include "pfv/pores/pore_network.hpp"
#include "pfv/pores/throat_measures.hpp"
#include "pfv/pores/wall_throat_block.hpp"

namespace pfv {

/// Gathers the corners of up to FacetBlock::width interior throats from `first` on; how many.
int gather(const PoreNetwork& network, std::size_t first, FacetBlock& block);

/// Likewise of throats at walls. One between two walls is crowded.
int gather(const PoreNetwork& network, std::size_t first, WallThroatBlock& block);

inline ThroatPlane plane(const FacetBlock& block, int lane) {
  return {{block.normal[0][lane], block.normal[1][lane], block.normal[2][lane]},
          block.area[lane],
          {block.sector[0][lane], block.sector[1][lane], block.sector[2][lane]},
          block.fluid_area[lane]};
}

inline ThroatPlane plane(const WallThroatBlock& block, int lane) {
  return {{block.normal[0][lane], block.normal[1][lane], block.normal[2][lane]},
          block.area[lane],
          block.by_vertex({block.sector[0][lane], block.sector[1][lane], 0}, lane),
          block.fluid_area[lane]};
}

/// Hands every throat in turn, with its facet, to `visit(throat, plane)`. Facets are quick to measure and long to keep.
template <typename Visit>
void visit_planes(const PoreNetwork& network, const Visit& visit) {
  const auto visit_block = [&](std::size_t first, int count, const auto& block) {
    for (int t = 0; t < count; ++t)
      visit(first + t, block.is_crowded(t) ? measure_plane(network.walls, network.sites.spheres, block.vertices[t])
                                           : plane(block, t));
  };
  FacetBlock facets{};
  for (std::size_t first = 0; first < network.throats.interior; first += FacetBlock::width) {
    const int count = gather(network, first, facets);
    facets.measure();
    visit_block(first, count, facets);
  }
  WallThroatBlock at_walls{};
  for (std::size_t first = network.throats.interior; first < network.throats.size(); first += FacetBlock::width) {
    const int count = gather(network, first, at_walls);
    at_walls.measure_facets();
    visit_block(first, count, at_walls);
  }
}

} // namespace pfv
