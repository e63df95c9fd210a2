#pragma once

#include "pfv/flow/flow_system.hpp"

#include <array>
#include <vector>

namespace pfv {

/// Pressure drop along a throat (Pa), from the pore behind to the one ahead as it is met there.
inline double pressure_drop(const PoreNetwork& network, const FlowSystem& system, const std::vector<double>& pressure,
                            std::size_t throat) {
  const auto [i, j] = network.throats.pores[throat];
  const double rise = network.throats.shift.empty() ? 0 : along(system.rise, network.throats.shift[throat]);
  return pressure[i] - pressure[j] - rise;
}

/// Flux through a throat (m^3/s), from the pore behind to the one ahead.
inline double throat_flux(const PoreNetwork& network, const FlowSystem& system, const std::vector<double>& pressure,
                          std::size_t throat) {
  return system.conductance[throat] * pressure_drop(network, system, pressure, throat);
}

/// What leaves the box (m^3/s).
struct Outflow {
  std::array<double, 6> face{}; // by index(Face); through a periodic face what enters by the opposite one
  std::vector<double> point;    // by pressure point
};
Outflow outflow(const PoreNetwork& network, const FlowSystem& system, const std::vector<double>& pressure);

/// Flux per area (m/s): the mean of the velocity over the box, solid included, sum q_ij (P_j - P_i) / V.
Vec3 mean_flux(const PoreNetwork& network, const FlowSystem& system, const std::vector<double>& pressure);

} // namespace pfv
