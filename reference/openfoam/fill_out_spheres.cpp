#include "reference/openfoam/fill_out_spheres.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace reference::openfoam {

namespace {

// What is known of a mesh point from the patches it is on.
struct SurfacePoint {
  std::optional<std::size_t> sphere;
  bool elsewhere = false; // on another sphere or a bridge as well
  double deficit = 0;     // sum over triangles of area times mean depth below the sphere
  double area = 0;
};

struct Depth {
  double area = 0;
  double times_area = 0; // integral of the depth below the sphere
};

// Over the triangles between the sides of a face and its middle.
Depth depth_of(const FoamMesh& mesh, std::size_t face, const pfv::Sphere& sphere) {
  Depth sum;
  const auto corners = mesh.face(face);
  const pfv::Vec3 c = mesh.middle(face) - sphere.centre;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const pfv::Vec3 a = mesh.points[corners[k]] - sphere.centre;
    const pfv::Vec3 b = mesh.points[corners[(k + 1) % corners.size()]] - sphere.centre;
    const double mean_square = (a.squaredNorm() + b.squaredNorm() + c.squaredNorm() + (a + b + c).squaredNorm()) / 12;
    const double area = (b - a).cross(c - a).norm() / 2;
    sum.area += area;
    sum.times_area += area * (sphere.radius * sphere.radius - mean_square) / (2 * sphere.radius);
  }
  return sum;
}

std::vector<SurfacePoint> surface_points(const FoamMesh& mesh, const std::vector<pfv::Sphere>& spheres) {
  std::vector<SurfacePoint> points(mesh.points.size());
  for (const MeshPatch& patch : mesh.patches) {
    if (std::holds_alternative<pfv::Face>(patch.part))
      continue;
    const auto* surface = std::get_if<SphereSurface>(&patch.part);
    for (std::size_t face = patch.first; face < patch.first + patch.faces; ++face) {
      const Depth depth = surface ? depth_of(mesh, face, spheres[surface->sphere]) : Depth{};
      for (const std::size_t index : mesh.face(face)) {
        SurfacePoint& point = points[index];
        if (!surface || (point.sphere && *point.sphere != surface->sphere)) {
          point.elsewhere = true;
          continue;
        }
        point.sphere = surface->sphere;
        point.deficit += depth.times_area;
        point.area += depth.area;
      }
    }
  }
  return points;
}

// Outward to `radius` from the sphere's centre, within the faces of the box that the point is on.
pfv::Vec3 moved(const pfv::Vec3& point, const pfv::Vec3& centre, double radius, const pfv::Box& box) {
  const double near = 1e-7 * box.size().maxCoeff();
  pfv::Vec3 free = point - centre;
  double fixed = 0;
  for (int axis = 0; axis < 3; ++axis)
    if (std::min(std::abs(point[axis] - box.lower[axis]), std::abs(point[axis] - box.upper[axis])) < near) {
      fixed += free[axis] * free[axis];
      free[axis] = 0;
    }
  const double length = free.norm();
  if (length < near || radius * radius <= fixed)
    return point;
  return point + free * (std::sqrt(radius * radius - fixed) / length - 1);
}

void put_on_spheres(FoamMesh& mesh, const pfv::Packing& packing) {
  for (const MeshPatch& patch : mesh.patches)
    if (const auto* surface = std::get_if<SphereSurface>(&patch.part))
      for (std::size_t face = patch.first; face < patch.first + patch.faces; ++face)
        for (const std::size_t point : mesh.face(face)) {
          const pfv::Sphere& sphere = packing.spheres[surface->sphere];
          mesh.points[point] = moved(mesh.points[point], sphere.centre, sphere.radius, packing.box);
        }
}

// Whether a face's cell lies on the inner side of it.
bool turned(const FoamMesh& mesh, std::size_t face) {
  const pfv::Vec3 area = mesh.area(face), centre = mesh.centre(face);
  return area.dot(centre - mesh.cell_centres[mesh.owner[face]]) <= 0 ||
         (face < mesh.neighbour.size() && area.dot(mesh.cell_centres[mesh.neighbour[face]] - centre) <= 0);
}

// Puts points of turned faces back until none is left; points only ever go back, so this ends.
void put_back_turned(FoamMesh& mesh, const std::vector<pfv::Vec3>& before, std::vector<char>& has_moved) {
  for (bool again = true; again;) {
    again = false;
    for (std::size_t face = 0; face < mesh.faces(); ++face) {
      if (!turned(mesh, face))
        continue;
      for (const std::size_t point : mesh.face(face))
        if (has_moved[point]) {
          mesh.points[point] = before[point];
          has_moved[point] = false;
          again = true;
        }
    }
    mesh.cell_centres = cell_centres(mesh);
  }
}

} // namespace

std::size_t fill_out_spheres(FoamMesh& mesh, const pfv::Packing& packing) {
  const auto before = mesh.points;
  put_on_spheres(mesh, packing);
  const auto surface = surface_points(mesh, packing.spheres);
  for (std::size_t index = 0; index < surface.size(); ++index)
    if (surface[index].elsewhere)
      mesh.points[index] = before[index];
  std::vector<char> has_moved(mesh.points.size(), false);
  for (std::size_t index = 0; index < surface.size(); ++index) {
    const SurfacePoint& point = surface[index];
    if (!point.sphere || point.elsewhere)
      continue;
    const pfv::Sphere& sphere = packing.spheres[*point.sphere];
    mesh.points[index] =
        moved(mesh.points[index], sphere.centre, sphere.radius + point.deficit / point.area, packing.box);
    has_moved[index] = true;
  }
  mesh.cell_centres = cell_centres(mesh);
  put_back_turned(mesh, before, has_moved);
  return static_cast<std::size_t>(std::ranges::count(has_moved, true));
}

} // namespace reference::openfoam
