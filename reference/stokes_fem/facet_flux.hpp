#pragma once

#include "reference/probes.hpp"
#include "reference/stokes_fem/cell_search.hpp"

namespace reference::stokes_fem {

/// Integral of u.n over the part of a flat facet that lies in cells of the mesh: every cell is cut by the facet's plane
/// and the cut clipped by the facet's sides, so no kink of the velocity lies inside a piece and three points in each of
/// its triangles are exact for a quadratic. A curved cell is cut as the eight straight ones between its ten nodes, the
/// velocity taken where the curved map puts it; what that misses is of second order in a layer where nearly nothing
/// flows. Where a facet lies in a plane of cell faces, the cells behind it count; those in front where the box ends
/// there and does not repeat.
double facet_flux(const FlowMesh& mesh, const CellSearch& search, const Probes::Facet& facet, const pfv::Box& box,
                  const pfv::PeriodicAxes& periodic);

} // namespace reference::stokes_fem
