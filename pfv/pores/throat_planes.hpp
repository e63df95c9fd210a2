#pragma once

#include "pfv/pores/facet_block.hpp"
#include "pfv/pores/pore_network.hpp"
#include "pfv/pores/throat_measures.hpp"

#include <functional>

namespace pfv {

/// Gathers the corners of up to FacetBlock::width interior throats from `first` on; how many.
int gather(const PoreNetwork& network, std::size_t first, FacetBlock& block);

/// Hands every throat in turn, with its facet, to `visit`. Facets are quick to measure and long to keep.
void visit_planes(const PoreNetwork& network, const std::function<void(std::size_t, const ThroatPlane&)>& visit);

} // namespace pfv
