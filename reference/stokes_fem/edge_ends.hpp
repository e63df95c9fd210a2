#pragma once

// Included only by the sources of this folder that speak deal.II.

#include "reference/stokes_fem/discretisation.hpp"

namespace reference::stokes_fem {

/// By velocity node the two corners of the edge it is the middle of; a corner itself is both.
std::vector<std::array<int, 2>> edge_ends(const Discretisation& discretisation);

} // namespace reference::stokes_fem
