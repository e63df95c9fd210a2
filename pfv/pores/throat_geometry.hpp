#pragma once

#include "pfv/pores/pore_network.hpp"

namespace pfv {

/// From sites, vertices and centres: the areas, lengths, volumes and surfaces of throats, pores, walls and spheres.
void measure(PoreNetwork& network);

} // namespace pfv
