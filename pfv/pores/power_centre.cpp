#include "pfv/pores/power_centre.hpp"

#include "pfv/pores/wall_distance.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <cmath>

namespace pfv {

PowerCentre power_centre(const Box& box, std::span<const Sphere> spheres, const std::array<Vertex, 4>& vertices) {
  int first = 0;
  while (is_wall(vertices[first]))
    ++first;
  const Sphere& origin = spheres[vertices[first]];

  // One plane per other vertex, n . x = d relative to the first sphere's centre: the radical plane or the wall itself.
  Eigen::Matrix3d normals;
  Vec3 distances;
  for (int v = 0, row = 0; v < 4; ++v) {
    if (v == first)
      continue;
    if (is_wall(vertices[v])) {
      const Face face = face_of(vertices[v]);
      normals.row(row) = outward_normal(face);
      distances[row] = wall_distance(box, face, origin.centre);
    } else {
      const Sphere& other = spheres[vertices[v]];
      const Vec3 apart = other.centre - origin.centre;
      const double length = apart.norm();
      normals.row(row) = apart / length;
      distances[row] = 0.5 * (length + (origin.radius - other.radius) * (origin.radius + other.radius) / length);
    }
    ++row;
  }
  PowerCentre result{Vec3::Zero(), std::abs(normals.determinant()), Vec3::Zero()};
  if (!result.flat()) {
    result.point = origin.centre + normals.inverse() * distances;
    return result;
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> parts(normals, Eigen::ComputeFullU | Eigen::ComputeFullV);
  result.point = origin.centre;
  for (int n = 0; n < 2; ++n)
    if (parts.singularValues()[n] > PowerCentre::flat_below)
      result.point += parts.matrixU().col(n).dot(distances) / parts.singularValues()[n] * parts.matrixV().col(n);
  result.normal = parts.matrixV().col(2);
  return result;
}

double pore_contrast(const Sphere& sphere, const Vec3& behind, const Vec3& ahead) {
  const double square = sphere.radius * sphere.radius;
  const double one = (behind - sphere.centre).squaredNorm() - square;
  const double other = (ahead - sphere.centre).squaredNorm() - square;
  const double sum = std::abs(one) + std::abs(other);
  return sum > 0 ? std::abs(one - other) / sum : 0;
}

} // namespace pfv
