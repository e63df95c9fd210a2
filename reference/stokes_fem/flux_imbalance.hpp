#pragma once

#include <array>
#include <cmath>

namespace reference::stokes_fem {

/// |inflow / outflow - 1| of the fluxes through the faces of the box; zero when nothing flows.
inline double flux_imbalance(const std::array<double, 6>& face_flux) {
  double inflow = 0;
  double outflow = 0;
  for (const double flux : face_flux)
    (flux > 0 ? outflow : inflow) += std::abs(flux);
  return inflow == outflow ? 0 : std::abs(inflow / outflow - 1);
}

} // namespace reference::stokes_fem
