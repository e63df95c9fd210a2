#include "reference/stokes_fem/exact_surface.hpp"

#include "reference/stokes_fem/bridge_gaps.hpp"

#include <Eigen/QR>

#include <algorithm>

namespace reference::stokes_fem {

namespace {

using pfv::Vec3;

struct DistanceAndNormal {
  double distance;
  Vec3 normal;
};

DistanceAndNormal evaluate(const Plane& plane, const Vec3& point) {
  return {plane.normal.dot(point) - plane.offset, plane.normal};
}

DistanceAndNormal evaluate(const pfv::Sphere& sphere, const Vec3& point) {
  const Vec3 arm = point - sphere.centre;
  return {arm.norm() - sphere.radius, arm.normalized()};
}

DistanceAndNormal evaluate(const Cylinder& cylinder, const Vec3& point) {
  const Vec3 along = point - cylinder.point;
  const Vec3 arm = along - along.dot(cylinder.direction) * cylinder.direction;
  return {arm.norm() - cylinder.radius, arm.normalized()};
}

DistanceAndNormal evaluate(const ExactSurface& surface, const Vec3& point) {
  return std::visit([&](const auto& shape) { return evaluate(shape, point); }, surface);
}

struct SurfaceOf {
  const pfv::Packing& packing;
  double bridge_radius;

  ExactSurface operator()(const BoxFace& label) const {
    const int axis = index(axis_of(label.face));
    return Plane{Vec3::Unit(axis), (is_upper(label.face) ? packing.box.upper : packing.box.lower)[axis]};
  }

  ExactSurface operator()(const SphereSurface& label) const { return packing.spheres[label.sphere]; }

  ExactSurface operator()(const Bridge& label) const {
    const pfv::Sphere& sphere = packing.spheres[label.sphere];
    const auto* other = std::get_if<std::size_t>(&label.other);
    const double smaller = other ? std::min(sphere.radius, packing.spheres[*other].radius) : sphere.radius;
    return Cylinder{sphere.centre, bridge_direction(label, packing), bridge_radius * smaller};
  }
};

} // namespace

ExactSurface exact_surface(const BoundaryLabel& label, const pfv::Packing& packing, double bridge_radius) {
  return std::visit(SurfaceOf{packing, bridge_radius}, label);
}

double distance(const ExactSurface& surface, const Vec3& point) {
  return evaluate(surface, point).distance;
}

std::optional<Vec3> project(const Vec3& start, std::span<const ExactSurface> surfaces, double reach) {
  const auto rows = static_cast<Eigen::Index>(surfaces.size());
  Eigen::MatrixXd normals(rows, 3);
  Eigen::VectorXd distances(rows);
  Vec3 point = start;
  for (int step = 0; step < 20; ++step) {
    for (Eigen::Index row = 0; row < rows; ++row) {
      const auto [gap, normal] = evaluate(surfaces[static_cast<std::size_t>(row)], point);
      distances[row] = gap;
      normals.row(row) = normal;
    }
    if (distances.cwiseAbs().maxCoeff() < 1e-13 * (1 + point.norm()))
      return point;
    point -= Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(normals).solve(distances);
    if (!((point - start).norm() < reach))
      return std::nullopt;
  }
  return std::nullopt;
}

} // namespace reference::stokes_fem
