#include "pfv/flow/fluid_forces.hpp"

#include "pfv/pores/throat_planes.hpp"

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

} // namespace

FluidForces fluid_forces(const PoreNetwork& network, const std::vector<double>& pressure,
                         const std::optional<Buoyancy>& buoyancy) {
  const std::size_t spheres = network.spheres.volume.size();
  FluidForces forces{std::vector<Vec3>(spheres, Vec3::Zero()), std::vector<Vec3>(spheres, Vec3::Zero()), {}, {}};
  forces.on_face.fill(Vec3::Zero());

  const auto& throats = network.throats;
  visit_planes(network, [&](std::size_t t, const ThroatPlane& plane) {
    const auto [i, j] = throats.pores[t];
    const Vec3 step = (pressure[i] - pressure[j]) * plane.normal;
    std::array<double, 3> wetted = throats.wetted_surface[t];
    for (int c = 0; c < 3; ++c)
      if (is_wall(throats.vertices[t][c]))
        wetted[c] = 0;
    const auto share = fluid_shares(wetted, plane.sector);
    for (int c = 0; c < 3; ++c) {
      if (is_wall(throats.vertices[t][c]))
        continue;
      const int k = network.sites.number[throats.vertices[t][c]];
      forces.pressure[k] += plane.sector[c] * step;
      forces.viscous[k] += plane.fluid_area() * share[c] * step;
    }
  });
  for (const auto& part : network.wall_parts)
    forces.on_face[index(part.face)] += pressure[part.pore] * part.area * outward_normal(part.face);

  if (buoyancy) {
    forces.buoyancy.emplace(spheres);
    for (std::size_t k = 0; k < spheres; ++k)
      (*forces.buoyancy)[k] = -buoyancy->fluid_density * network.spheres.volume[k] * buoyancy->gravity;
  }
  return forces;
}

} // namespace pfv
