#include "reference/probes.hpp"

#include <algorithm>

namespace reference {

namespace {

using pfv::Vec3;

double wall_coordinate(const pfv::Box& box, pfv::Face face) {
  const auto axis = static_cast<Eigen::Index>(index(axis_of(face)));
  return (pfv::is_upper(face) ? box.upper : box.lower)[axis];
}

Vec3 onto(const pfv::Box& box, pfv::Vertex wall, Vec3 point) {
  const pfv::Face face = pfv::face_of(wall);
  point[static_cast<Eigen::Index>(index(axis_of(face)))] = wall_coordinate(box, face);
  return point;
}

// A wall is a sphere of infinite radius: the edges that lead to it are perpendicular to it and end on it. With one wall
// the facet is a trapezium, with two a rectangle that ends on the edge of the box.
Probes::Facet facet(const pfv::PoreNetwork& network, const std::array<pfv::Vertex, 3>& vertices) {
  int walls = 0;
  for (const pfv::Vertex vertex : vertices)
    walls += pfv::is_wall(vertex) ? 1 : 0;
  std::array<pfv::Vertex, 3> v = vertices;
  const auto centre = [&](pfv::Vertex vertex) {
    return network.sites.spheres[static_cast<std::size_t>(vertex)].centre;
  };
  if (walls == 0)
    return {centre(v[0]), centre(v[1]), centre(v[2])};
  // Turn until the single odd one, wall or sphere, is first.
  while (pfv::is_wall(v[0]) == pfv::is_wall(v[1]) || pfv::is_wall(v[0]) == pfv::is_wall(v[2]))
    v = {v[1], v[2], v[0]};
  if (walls == 1)
    return {onto(network.box, v[0], centre(v[1])), centre(v[1]), centre(v[2]), onto(network.box, v[0], centre(v[2]))};
  const Vec3 sphere = centre(v[0]), first = onto(network.box, v[1], sphere), second = onto(network.box, v[2], sphere);
  return {sphere, first, onto(network.box, v[2], first), second};
}

// Nine lines along the axis, on a 3 x 3 grid across it.
void add_lines(const pfv::Box& box, pfv::Axis along, std::vector<Vec3>& points) {
  const auto axis = static_cast<Eigen::Index>(index(along));
  for (int line = 0; line < 9; ++line) {
    for (std::size_t i = 0; i < PoreProbes::points_per_line; ++i) {
      Vec3 share;
      share[axis] = (static_cast<double>(i) + 0.5) / static_cast<double>(PoreProbes::points_per_line);
      share[(axis + 1) % 3] = (line % 3 + 0.5) / 3;
      share[(axis + 2) % 3] = (line / 3 + 0.5) / 3; // NOLINT(bugprone-integer-division)
      points.push_back(box.lower + share.cwiseProduct(box.size()));
    }
  }
}

} // namespace

PoreProbes pore_probes(const pfv::Case& problem, const pfv::PoreNetwork& network) {
  PoreProbes result;
  Probes& probes = result.probes;
  probes.points = network.pores.centre;
  result.lines = probes.points.size();
  const auto setup = permeability_setup(problem);
  add_lines(problem.packing.box, setup ? setup->axis : pfv::Axis::z, probes.points);
  probes.facets.reserve(network.throats.size());
  for (std::size_t throat = 0; throat < network.throats.size(); ++throat)
    probes.facets.push_back(facet(network, network.corners(throat)));
  return result;
}

PoreProbes pore_probes(const pfv::Case& problem) {
  pfv::Clock clock;
  return pore_probes(problem, build_pore_network(problem.packing, periodic_axes(problem.faces), clock));
}

bool in_solid(const pfv::Packing& packing, const Vec3& point) {
  return std::ranges::any_of(packing.spheres, [&](const pfv::Sphere& sphere) {
    return (point - sphere.centre).squaredNorm() < sphere.radius * sphere.radius;
  });
}

} // namespace reference
