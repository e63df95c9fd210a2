#include "meshing/measure_mesh.hpp"

#include "meshing/exact_void.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meshing {

namespace {

double triangle_area(const pfv::Vec3& a, const pfv::Vec3& b, const pfv::Vec3& c) {
  return (b - a).cross(c - a).norm() / 2;
}

double signed_volume(const std::array<pfv::Vec3, 4>& p) {
  return (p[1] - p[0]).dot((p[2] - p[0]).cross(p[3] - p[0])) / 6;
}

} // namespace

double tetrahedron_quality(const std::array<pfv::Vec3, 4>& p) {
  const double volume = signed_volume(p);
  const double surface = triangle_area(p[1], p[2], p[3]) + triangle_area(p[0], p[2], p[3]) +
                         triangle_area(p[0], p[1], p[3]) + triangle_area(p[0], p[1], p[2]);
  // Crelle: 6 V R is the area of the triangle whose sides are the products of opposite edges.
  const double a = (p[1] - p[0]).norm() * (p[3] - p[2]).norm();
  const double b = (p[2] - p[0]).norm() * (p[3] - p[1]).norm();
  const double c = (p[3] - p[0]).norm() * (p[2] - p[1]).norm();
  const double half = (a + b + c) / 2;
  const double area = std::sqrt(std::max(0.0, half * (half - a) * (half - b) * (half - c)));
  if (area == 0 || surface == 0)
    return 0;
  const double inradius = 3 * volume / surface;
  const double circumradius = area / (6 * std::abs(volume));
  return 3 * inradius / circumradius;
}

MeshQuality measure_mesh(const LinearMesh& mesh, const pfv::Packing& packing) {
  MeshQuality quality;
  quality.nodes = mesh.nodes.size();
  quality.tetrahedra = mesh.tetrahedra.size();
  quality.worst_quality = mesh.tetrahedra.empty() ? 0 : std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c, d] : mesh.tetrahedra) {
    const std::array corners{mesh.nodes[a], mesh.nodes[b], mesh.nodes[c], mesh.nodes[d]};
    quality.volume += signed_volume(corners);
    quality.worst_quality = std::min(quality.worst_quality, tetrahedron_quality(corners));
  }
  for (const auto& [nodes, surface] : mesh.triangles)
    if (mesh.surfaces[surface].starts_with("sphere_"))
      quality.surface += triangle_area(mesh.nodes[nodes[0]], mesh.nodes[nodes[1]], mesh.nodes[nodes[2]]);
  quality.bridges = static_cast<std::size_t>(
      std::ranges::count_if(mesh.surfaces, [](const std::string& name) { return name.starts_with("bridge_"); }));
  const VoidMeasure exact = exact_void(packing);
  quality.exact_volume = exact.volume;
  quality.volume_error = quality.volume / exact.volume - 1;
  quality.exact_surface = exact.surface;
  quality.surface_error = quality.surface / exact.surface - 1;
  return quality;
}

} // namespace meshing
