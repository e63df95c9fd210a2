#include "pfv/simulation/vertex_flux.hpp"

#include "pfv/problem/error.hpp"

namespace pfv {

SolidFlux vertex_flux(const PoreNetwork& network) {
  if (!network.wall_parts.empty())
    throw InputError("rates of volume by vertices are for boxes that are periodic along all axes");
  SolidFlux flux;
  flux.bodies = network.spheres.volume.size() + 6;
  for (const auto& vertices : network.pores.vertices) {
    std::array<Vec3, 4> at;
    std::array<int, 4> body;
    for (int c = 0; c < 4; ++c) {
      at[c] = network.sites.spheres[vertices[c]].centre;
      body[c] = network.sites.number[vertices[c]];
    }
    const double sign = (at[1] - at[0]).cross(at[2] - at[0]).dot(at[3] - at[0]) > 0 ? 1 : -1;
    // The volume, sign (b - a) x (c - a).(d - a) / 6, by each vertex; what fills a pore leaves no room for the fluid.
    std::array<Vec3, 4> weight;
    weight[1] = (at[2] - at[0]).cross(at[3] - at[0]);
    weight[2] = (at[3] - at[0]).cross(at[1] - at[0]);
    weight[3] = (at[1] - at[0]).cross(at[2] - at[0]);
    weight[0] = -(weight[1] + weight[2] + weight[3]);
    for (Vec3& of : weight)
      of *= sign / 6;
    flux.weight.push_back(weight);
    flux.body.push_back(body);
  }
  return flux;
}

} // namespace pfv
