#include "pfv/simulation/solid_flux.hpp"

#include "pfv/flow/fluid_parts.hpp"
#include "pfv/pores/throat_planes.hpp"

#include <algorithm>

namespace pfv {
namespace {

int corner_of(const std::array<Vertex, 4>& vertices, Vertex vertex) {
  return static_cast<int>(std::ranges::find(vertices, vertex) - vertices.begin());
}

SolidFlux without_weights(const PoreNetwork& network) {
  SolidFlux flux;
  const auto spheres = static_cast<int>(network.spheres.volume.size());
  flux.bodies = spheres + 6;
  flux.weight.assign(network.pores.size(), {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()});
  flux.body.reserve(network.pores.size());
  for (const auto& vertices : network.pores.vertices) {
    std::array<int, 4> body;
    for (int c = 0; c < 4; ++c)
      body[c] = is_wall(vertices[c]) ? spheres + index(face_of(vertices[c])) : network.sites.number[vertices[c]];
    flux.body.push_back(body);
  }
  return flux;
}

/// Which vertex of the pore ahead of throat t is this corner, or in a periodic box the image of it that the pore has.
int corner_ahead(const PoreNetwork& network, std::size_t t, Vertex corner) {
  const auto& vertices = network.pores.vertices[network.throats.pores[t][1]];
  if (network.throats.shift.empty() || is_wall(corner))
    return corner_of(vertices, corner);
  const auto& sites = network.sites;
  const auto is_it = [&](Vertex v) {
    return !is_wall(v) && sites.number[v] == sites.number[corner] &&
           sites.shift[v] + network.throats.shift[t] == sites.shift[corner];
  };
  return static_cast<int>(std::ranges::find_if(vertices, is_it) - vertices.begin());
}

} // namespace

SolidFlux solid_flux(const PoreNetwork& network, const WallRule& walls) {
  SolidFlux flux = without_weights(network);
  const double wall_share = std::visit([](const auto& rule) -> double { return rule.surface; }, walls);
  visit_planes(network, [&](std::size_t t, const ThroatPlane& plane) {
    const auto [i, j] = network.throats.pores[t];
    const auto corners = network.corners(t);
    const auto fluid = fluid_parts(network, t, corners, plane, wall_share); // with the sectors all of the facet
    for (int c = 0; c < 3; ++c) {
      const Vec3 area = (plane.sector[c] + fluid[c]) * plane.normal;
      flux.weight[i][corner_of(network.pores.vertices[i], corners[c])] += area;
      flux.weight[j][corner_ahead(network, t, corners[c])] -= area;
    }
  });
  for (const auto& part : network.wall_parts) {
    const auto& body = flux.body[part.pore];
    const int wall = static_cast<int>(flux.bodies) - 6 + index(part.face);
    flux.weight[part.pore][std::ranges::find(body, wall) - body.begin()] += part.area * outward_normal(part.face);
  }
  return flux;
}

void volume_rates(const SolidFlux& flux, std::span<const Vec3> velocity, std::vector<double>& rate) {
  rate.resize(flux.pores());
  for (std::size_t i = 0; i < flux.pores(); ++i) {
    const auto& weight = flux.weight[i];
    const auto& body = flux.body[i];
    rate[i] = weight[0].dot(velocity[body[0]]) + weight[1].dot(velocity[body[1]]) + weight[2].dot(velocity[body[2]]) +
              weight[3].dot(velocity[body[3]]);
  }
}

void pressure_forces(const SolidFlux& flux, std::span<const double> pressure, std::vector<Vec3>& force) {
  force.assign(flux.bodies, Vec3::Zero());
  for (std::size_t i = 0; i < flux.pores(); ++i)
    for (int c = 0; c < 4; ++c)
      force[flux.body[i][c]] += pressure[i] * flux.weight[i][c];
}

} // namespace pfv
