#include "pfv/pores/power_centre.hpp"

#include "pfv/pores/wall_distance.hpp"

#include <Eigen/LU>
#include <Eigen/QR>

namespace pfv {

Vec3 power_centre(const Packing& packing, const std::array<Vertex, 4>& vertices) {
  int first = 0;
  while (is_wall(vertices[first]))
    ++first;
  const Sphere& origin = packing.spheres[vertices[first]];

  // One plane per other vertex, n . x = d relative to the first sphere's centre: the radical plane or the wall itself.
  Eigen::Matrix3d normals;
  Vec3 distances;
  for (int v = 0, row = 0; v < 4; ++v) {
    if (v == first)
      continue;
    if (is_wall(vertices[v])) {
      const Face face = face_of(vertices[v]);
      normals.row(row) = outward_normal(face);
      distances[row] = wall_distance(packing.box, face, origin.centre);
    } else {
      const Sphere& other = packing.spheres[vertices[v]];
      const Vec3 apart = other.centre - origin.centre;
      const double length = apart.norm();
      normals.row(row) = apart / length;
      distances[row] = 0.5 * (length + (origin.radius - other.radius) * (origin.radius + other.radius) / length);
    }
    ++row;
  }
  constexpr double flat = 1e-13; // of the unit directions' volume
  if (std::abs(normals.determinant()) > flat)
    return origin.centre + normals.inverse() * distances;
  Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix3d> nearest;
  nearest.setThreshold(1e-10);
  nearest.compute(normals);
  return origin.centre + nearest.solve(distances);
}

} // namespace pfv
