#include "pfv/flow/fluid_forces.hpp"

#include "pfv/flow/fluxes.hpp"
#include "pfv/pores/throat_planes.hpp"

#include <algorithm>

namespace pfv {
namespace {

/// Shares of the vertices of a throat in its fluid area: by wetted surface, by disc sector where that is not positive.
std::array<double, 3> fluid_shares(const std::array<double, 3>& wetted, const std::array<double, 3>& sector) {
  const auto sum = [](const std::array<double, 3>& of) { return of[0] + of[1] + of[2]; };
  const auto& by = sum(wetted) > 0 ? wetted : sector;
  const double total = sum(by);
  if (!(total > 0))
    return {};
  return {by[0] / total, by[1] / total, by[2] / total};
}

void clear(std::vector<Vec3>& vectors, std::size_t count) {
  vectors.resize(count);
  std::ranges::fill(vectors, Vec3::Zero());
}

} // namespace

void update(FluidForces& forces, const PoreNetwork& network, const FlowSystem& system,
            const std::vector<double>& pressure, const WallRule& walls, const std::optional<Buoyancy>& buoyancy) {
  const std::size_t spheres = network.spheres.volume.size();
  clear(forces.pressure, spheres);
  clear(forces.viscous, spheres);
  forces.on_face.fill(Vec3::Zero());
  const double wall_share = std::visit([](const auto& rule) -> double { return rule.surface; }, walls);

  const auto& throats = network.throats;
  visit_planes(network, [&](std::size_t t, const ThroatPlane& plane) {
    const Vec3 step = pressure_drop(network, system, pressure, t) * plane.normal;
    std::array<double, 3> wetted = throats.wetted_surface[t];
    const auto corners = network.corners(t);
    for (int c = 0; c < 3; ++c)
      if (is_wall(corners[c]))
        wetted[c] *= wall_share;
    const auto share = fluid_shares(wetted, plane.sector);
    for (int c = 0; c < 3; ++c) {
      const Vertex v = corners[c];
      const Vec3 viscous = plane.fluid_area() * share[c] * step;
      if (is_wall(v)) {
        forces.on_face[index(face_of(v))] += viscous;
        continue;
      }
      forces.pressure[network.sites.number[v]] += plane.sector[c] * step;
      forces.viscous[network.sites.number[v]] += viscous;
    }
  });
  for (const auto& part : network.wall_parts)
    forces.on_face[index(part.face)] += pressure[part.pore] * part.area * outward_normal(part.face);

  if (buoyancy) {
    if (!forces.buoyancy)
      forces.buoyancy.emplace();
    forces.buoyancy->resize(spheres);
    for (std::size_t k = 0; k < spheres; ++k)
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
