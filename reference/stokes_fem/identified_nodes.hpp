#pragma once

// Included only by the sources of this folder that speak deal.II.

#include "reference/stokes_fem/curved_mapping.hpp"
#include "reference/stokes_fem/discretisation.hpp"

namespace reference::stokes_fem {

/// Vertices of the mesh numbered so that those above each other on periodic faces share a number, the lowest of them.
/// Throws pfv::SolveError when one has none opposite.
std::vector<unsigned> identified_vertices(const Discretisation& space, const pfv::Box& box,
                                          const pfv::PeriodicAxes& periodic);

/// Fills velocity_node, pressure_node and their counts: the numbers of the library's nodes, those above each other on
/// periodic faces taken as one. Throws pfv::SolveError when one has none opposite.
void identify_nodes(Discretisation& space, const pfv::Box& box, const pfv::PeriodicAxes& periodic);

} // namespace reference::stokes_fem
