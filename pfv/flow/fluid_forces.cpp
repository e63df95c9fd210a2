#include "pfv/flow/fluid_forces.hpp"

namespace pfv {
namespace {

/// Shares of the spheres of a throat in its fluid area: by wetted surface, by disc sector where that is not positive.
std::array<double, 3> fluid_shares(const PoreNetwork::Throats& throats, std::size_t t) {
  const auto& wetted = throats.wetted_surface[t];
  const auto& sector = throats.sector_area[t];
  const double total_wetted = throats.total_wetted_surface(t);
  const double total_sector = sector[0] + sector[1] + sector[2];
  std::array<double, 3> share{};
  for (int c = 0; c < 3; ++c) {
    if (total_wetted > 0)
      share[c] = wetted[c] / total_wetted;
    else if (total_sector > 0)
      share[c] = sector[c] / total_sector;
  }
  return share;
}

} // namespace

FluidForces fluid_forces(const PoreNetwork& network, const std::vector<double>& pressure,
                         const std::optional<Buoyancy>& buoyancy) {
  const std::size_t spheres = network.spheres.volume.size();
  FluidForces forces{std::vector<Vec3>(spheres, Vec3::Zero()), std::vector<Vec3>(spheres, Vec3::Zero()), {}, {}};
  forces.on_face.fill(Vec3::Zero());

  const auto& throats = network.throats;
  for (std::size_t t = 0; t < throats.size(); ++t) {
    const auto [i, j] = throats.pores[t];
    const Vec3 step = (pressure[i] - pressure[j]) * throats.normal[t];
    const auto share = fluid_shares(throats, t);
    for (int c = 0; c < 3; ++c) {
      const Vertex k = throats.vertices[t][c];
      if (is_wall(k))
        continue;
      forces.pressure[k] += throats.sector_area[t][c] * step;
      forces.viscous[k] += throats.fluid_area[t] * share[c] * step;
    }
  }
  for (std::size_t i = 0; i < network.pores.size(); ++i)
    for (const Face face : all_faces)
      forces.on_face[index(face)] += pressure[i] * network.pores.wall_area[i][index(face)] * outward_normal(face);

  if (buoyancy) {
    forces.buoyancy.emplace(spheres);
    for (std::size_t k = 0; k < spheres; ++k)
      (*forces.buoyancy)[k] = -buoyancy->fluid_density * network.spheres.volume[k] * buoyancy->gravity;
  }
  return forces;
}

} // namespace pfv
