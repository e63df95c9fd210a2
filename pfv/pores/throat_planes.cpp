#include "pfv/pores/throat_planes.hpp"

#include "pfv/pores/wall_distance.hpp"

#include <algorithm>

namespace pfv {
namespace {

void set(FacetBlock::Corner& corner, int lane, const Sphere& sphere) {
  corner.x[lane] = sphere.centre.x();
  corner.y[lane] = sphere.centre.y();
  corner.z[lane] = sphere.centre.z();
  corner.radius[lane] = sphere.radius;
}

} // namespace

int gather(const PoreNetwork& network, std::size_t first, FacetBlock& block) {
  const auto& throats = network.throats;
  const int count = static_cast<int>(std::min<std::size_t>(FacetBlock::width, throats.interior - first));
  for (int t = 0; t < count; ++t) {
    const auto& corners = block.vertices[t] = network.corners(first + t);
    for (int c = 0; c < 3; ++c)
      set(block.corners[c], t, network.sites.spheres[corners[c]]);
  }
  return count;
}

int gather(const PoreNetwork& network, std::size_t first, WallThroatBlock& block) {
  const int count = static_cast<int>(std::min<std::size_t>(WallThroatBlock::width, network.throats.size() - first));
  for (int t = 0; t < count; ++t) {
    const auto& corners = block.vertices[t] = network.corners(first + t);
    int& wall = block.wall[t] = 0;
    while (!is_wall(corners[wall]))
      ++wall;
    const Face face = face_of(corners[wall]);
    const Vec3 outward = outward_normal(face);
    for (int axis = 0; axis < 3; ++axis)
      block.outward[axis][t] = outward[axis];
    for (int k = 0; k < 2; ++k) {
      const Vertex own = corners[(wall + 1 + k) % 3], other = corners[(wall + 2 - k) % 3];
      const Sphere& sphere = network.sites.spheres[is_wall(own) ? other : own]; // with itself it overlaps
      set(block.corners[k], t, sphere);
      block.distance[k][t] = wall_distance(network.walls, face, sphere.centre);
    }
  }
  return count;
}

} // namespace pfv
