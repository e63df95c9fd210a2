#include "pfv/flow/fluid_forces.hpp"

#include "pfv/flow/fluid_parts.hpp"
#include "pfv/flow/fluxes.hpp"
#include "pfv/pores/throat_planes.hpp"

#include <algorithm>

namespace pfv {
namespace {

void clear(std::vector<Vec3>& vectors, std::size_t count) {
  vectors.resize(count);
  std::ranges::fill(vectors, Vec3::Zero());
}

} // namespace

void update(FluidForces& forces, const PoreNetwork& network, const FlowSystem& system,
            const std::vector<double>& pressure, const WallRule& walls, const std::optional<Buoyancy>& buoyancy) {
  auto& of_sites = forces.of_sites;
  of_sites.resize(network.sites.size());
  std::ranges::fill(of_sites, FluidForces::OfSite{});
  forces.on_face.fill(Vec3::Zero());
  const double wall_share = std::visit([](const auto& rule) -> double { return rule.surface; }, walls);

  visit_planes(network, [&](std::size_t t, const ThroatPlane& plane) {
    const Vec3 step = pressure_drop(network, system, pressure, t) * plane.normal;
    const auto corners = network.corners(t);
    const auto part = fluid_parts(network, t, corners, plane, wall_share);
    for (int c = 0; c < 3; ++c) {
      if (is_wall(corners[c])) {
        forces.on_face[index(face_of(corners[c]))] += part[c] * step;
      } else {
        FluidForces::OfSite& site = of_sites[corners[c]];
        site.pressure += plane.sector[c] * step;
        site.viscous += part[c] * step;
      }
    }
  });
  clear(forces.pressure, network.spheres.volume.size());
  clear(forces.viscous, network.spheres.volume.size());
  for (std::size_t s = 0; s < of_sites.size(); ++s) {
    forces.pressure[network.sites.number[s]] += of_sites[s].pressure;
    forces.viscous[network.sites.number[s]] += of_sites[s].viscous;
  }
  for (const auto& part : network.wall_parts)
    forces.on_face[index(part.face)] += pressure[part.pore] * part.area * outward_normal(part.face);

  if (buoyancy) {
    if (!forces.buoyancy)
      forces.buoyancy.emplace();
    forces.buoyancy->resize(network.spheres.volume.size());
    for (std::size_t k = 0; k < forces.buoyancy->size(); ++k)
      (*forces.buoyancy)[k] = -buoyancy->fluid_density * network.spheres.volume[k] * buoyancy->gravity;
  }
}

FluidForces fluid_forces(const PoreNetwork& network, const FlowSystem& system, const std::vector<double>& pressure,
                         const WallRule& walls, const std::optional<Buoyancy>& buoyancy) {
  FluidForces forces;
  update(forces, network, system, pressure, walls, buoyancy);
  return forces;
}

} // namespace pfv
