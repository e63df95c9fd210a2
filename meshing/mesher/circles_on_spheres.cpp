#include "meshing/mesher/circles_on_spheres.hpp"

#include "pfv/problem/face.hpp"

#include <cmath>

namespace mesher {
namespace {

using pfv::Vec3;

void add_where_planes_cut(const pfv::Sphere& sphere, const pfv::Box& box, Circles& circles) {
  for (const pfv::Face face : pfv::all_faces) {
    const Vec3 normal = pfv::outward_normal(face);
    const double distance = normal.dot((pfv::is_upper(face) ? box.upper : box.lower) - sphere.centre);
    if (std::abs(distance) < sphere.radius)
      circles.push_back({normal, std::acos(distance / sphere.radius)});
  }
}

void add_where_spheres_cut(const pfv::Sphere& sphere, const pfv::Sphere& other, Circles& circles) {
  const Vec3 to = other.centre - sphere.centre;
  const double distance = to.norm();
  const double offset =
      (distance * distance + sphere.radius * sphere.radius - other.radius * other.radius) / (2 * distance);
  if (std::abs(offset) < sphere.radius)
    circles.push_back({to / distance, std::acos(offset / sphere.radius)});
}

/// The circle where a bridge leaves a sphere, if it is one of its two.
void add_where_bridge_leaves(const pfv::Sphere& sphere, const meshing::Bridge& bridge, Circles& circles) {
  const Vec3 along = (bridge.to - bridge.from).normalized();
  if ((bridge.from - sphere.centre).norm() < sphere.radius &&
      (bridge.from - sphere.centre).cross(along).norm() < 1e-9 * sphere.radius)
    circles.push_back({along, std::asin(bridge.radius / sphere.radius)});
  if ((bridge.to - sphere.centre).norm() < sphere.radius &&
      (bridge.to - sphere.centre).cross(along).norm() < 1e-9 * sphere.radius)
    circles.push_back({-along, std::asin(bridge.radius / sphere.radius)});
}

/// Corners where two circles of a sphere meet inside the box.
void add_corners(const pfv::Sphere& sphere, const pfv::Box& box, Circles& circles) {
  const std::size_t count = circles.size();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 &a = circles[i].axis, &b = circles[j].axis;
      const Vec3 across = a.cross(b);
      const double sine_squared = across.squaredNorm();
      if (sine_squared < 1e-12)
        continue;
      const double cosine = a.dot(b), in_a = std::cos(circles[i].angle), in_b = std::cos(circles[j].angle);
      const Vec3 within = ((in_a - in_b * cosine) * a + (in_b - in_a * cosine) * b) / sine_squared;
      const double rest = (1 - within.squaredNorm()) / sine_squared;
      if (rest <= 0)
        continue;
      for (const double side : {-1.0, 1.0}) {
        const Vec3 corner = within + side * std::sqrt(rest) * across;
        const Vec3 point = sphere.centre + sphere.radius * corner;
        const double tolerance = 1e-6 * sphere.radius;
        if ((point - box.lower).minCoeff() > -tolerance && (box.upper - point).minCoeff() > -tolerance)
          circles.push_back({corner, 0});
      }
    }
}

} // namespace

std::vector<Circles> circles_on_spheres(const pfv::Packing& packing, const std::vector<meshing::Bridge>& bridges) {
  const auto& spheres = packing.spheres;
  std::vector<Circles> circles(spheres.size());
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    add_where_planes_cut(spheres[k], packing.box, circles[k]);
    for (std::size_t other = 0; other < spheres.size(); ++other)
      if (other != k)
        add_where_spheres_cut(spheres[k], spheres[other], circles[k]);
    for (const meshing::Bridge& bridge : bridges)
      add_where_bridge_leaves(spheres[k], bridge, circles[k]);
    add_corners(spheres[k], packing.box, circles[k]);
  }
  return circles;
}

} // namespace mesher
