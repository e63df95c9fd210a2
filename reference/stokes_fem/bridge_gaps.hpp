#pragma once

#include "pfv/problem/packing.hpp"
#include "reference/stokes_fem/boundary_labels.hpp"

namespace reference::stokes_fem {

/// Area of a bridge's end inside the box: a disc of radius `bridge_radius` times the smaller sphere's, halved by every
/// face of the box its axis lies in, unless that is periodic.
double bridge_section(const Bridge& bridge, const pfv::Packing& packing, double bridge_radius,
                      const pfv::PeriodicAxes& periodic = {});

/// Unit vector along a bridge's axis, from its sphere to the other end.
pfv::Vec3 bridge_direction(const Bridge& bridge, const pfv::Packing& packing);

} // namespace reference::stokes_fem
