#include "pfv/flow/fluxes.hpp"

namespace pfv {

Outflow outflow(const PoreNetwork& network, const FlowSystem& system, const std::vector<double>& pressure) {
  Outflow out{{}, std::vector<double>(system.points, 0.0)};
  const auto add = [&](const FlowSystem::KnownPore* pore, double flux) {
    if (pore && pore->source >= 0)
      (pore->source < 6 ? out.face[pore->source] : out.point[pore->source - 6]) += flux;
  };
  const bool periodic = !system.offset.empty();
  for (std::size_t t = 0; t < network.throats.size(); ++t) {
    const auto [i, j] = network.throats.pores[t];
    const auto *behind = system.known(i), *ahead = system.known(j);
    if (!periodic && !behind && !ahead)
      continue;
    const double q = throat_flux(network, system, pressure, t);
    add(behind, -q);
    add(ahead, q);
    if (!periodic)
      continue;
    const Shift boxes = crossing(system, network, t);
    for (int axis = 0; axis < 3; ++axis) {
      out.face[2 * axis] -= q * boxes[axis];
      out.face[2 * axis + 1] += q * boxes[axis];
    }
  }
  return out;
}

Vec3 mean_flux(const PoreNetwork& network, const FlowSystem& system, const std::vector<double>& pressure) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t t = 0; t < network.throats.size(); ++t)
    sum += throat_flux(network, system, pressure, t) *
           (network.centre_ahead(t) - network.pores.centre[network.throats.pores[t][0]]);
  return sum / network.box.volume();
}

} // namespace pfv
