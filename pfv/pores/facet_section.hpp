#pragma once

#include "pfv/pores/facet.hpp"

#include <array>
#include <span>

namespace pfv {

/// Area (m^2) of the facet that each of its spheres covers, by corner; 0 at walls. Where discs overlap each keeps what
/// lies on its own side of their radical line, so that the three together are their union inside the facet, also
/// where all share a point or reach across a side. Box and spheres must be those that the facet was made of.
std::array<double, 3> covered_parts(const Box& box, std::span<const Sphere> spheres, const Facet& facet);

} // namespace pfv
