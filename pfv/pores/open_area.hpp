#pragma once

#include "pfv/pores/lanes.hpp"

namespace pfv {

/// m^2, what the sectors of its spheres leave open of a facet, S_f. 0 when so little is left, of the facet or of the
/// section of its largest sphere, that it is round-off: the spheres cover the facet.
PFV_INLINE double open_area(double area, double sectors, double largest_radius) {
  constexpr double round_off = 1e-14;
  const double open = area - sectors, section = largest_radius * largest_radius;
  return open > round_off * (area > section ? area : section) ? open : 0;
}

} // namespace pfv
