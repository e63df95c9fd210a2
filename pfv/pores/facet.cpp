#include "pfv/pores/facet.hpp"

#include "pfv/pores/wall_distance.hpp"

#include <algorithm>

namespace pfv {
namespace {

Vec3 area_vector(const Box& box, std::span<const Sphere> spheres, const std::array<Vertex, 3>& vertices) {
  int first_sphere = 0;
  while (is_wall(vertices[first_sphere]))
    ++first_sphere;
  const Vertex a = vertices[first_sphere], b = vertices[(first_sphere + 1) % 3], c = vertices[(first_sphere + 2) % 3];
  const Vec3& at = spheres[a].centre;
  const auto to = [&](Vertex v) -> Vec3 {
    return is_wall(v) ? outward_normal(face_of(v)) : Vec3(spheres[v].centre - at);
  };
  const auto reach = [&](Vertex sphere, Vertex wall) {
    return wall_distance(box, face_of(wall), spheres[sphere].centre);
  };
  const Vec3 cross = to(b).cross(to(c));
  if (is_wall(b) && is_wall(c))
    return reach(a, b) * reach(a, c) * cross;
  if (is_wall(b))
    return 0.5 * (reach(a, b) + reach(c, b)) * cross;
  if (is_wall(c))
    return 0.5 * (reach(a, c) + reach(b, c)) * cross;
  return 0.5 * cross;
}

double gap_between(const Sphere& one, const Sphere& other) {
  const double apart = (other.centre - one.centre).norm(), radii = one.radius + other.radius;
  return apart > radii ? 1 - radii / apart : 0;
}

/// Between a sphere and its mirror image. One that the wall cuts parts from its image again, as it were, until both are
/// one sphere, centred on the wall.
double gap_at_wall(const Box& box, Face face, const Sphere& sphere) {
  const double distance = wall_distance(box, face, sphere.centre), radius = sphere.radius;
  if (distance > radius)
    return 1 - radius / distance;
  const double inside = std::min(1.0, 1 - distance / radius);
  return inside * inside;
}

} // namespace

Facet make_facet(const Box& box, std::span<const Sphere> spheres, const std::array<Vertex, 3>& vertices) {
  Facet facet;
  const auto direction = [&](Vertex from, Vertex to) -> Vec3 {
    if (is_wall(to))
      return outward_normal(face_of(to));
    if (is_wall(from))
      return -outward_normal(face_of(from));
    return spheres[to].centre - spheres[from].centre;
  };
  for (int c = 0; c < 3; ++c) {
    const Vertex vertex = vertices[c];
    facet.corners[c] = {vertex, direction(vertex, vertices[(c + 1) % 3]), direction(vertex, vertices[(c + 2) % 3])};
    if (!is_wall(vertex))
      facet.point = spheres[vertex].centre;
  }
  const Vec3 vector = area_vector(box, spheres, vertices);
  facet.area = vector.norm();
  for (const auto& corner : facet.corners) // the direction survives where the area is zero: spheres centred on a wall
    if (!is_wall(corner.vertex))
      facet.normal = corner.to_next.cross(corner.to_previous).normalized();
  return facet;
}

double smallest_gap(const Box& box, std::span<const Sphere> spheres, const std::array<Vertex, 3>& vertices) {
  double smallest = 1;
  for (int c = 0; c < 3; ++c) {
    const Vertex one = vertices[c], other = vertices[(c + 1) % 3];
    if (is_wall(one) && is_wall(other))
      continue;
    if (is_wall(one) || is_wall(other))
      smallest = std::min(smallest,
                          gap_at_wall(box, face_of(is_wall(one) ? one : other), spheres[is_wall(one) ? other : one]));
    else
      smallest = std::min(smallest, gap_between(spheres[one], spheres[other]));
  }
  return smallest;
}

} // namespace pfv
