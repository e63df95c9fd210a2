#pragma once

#include "pfv/problem/packing.hpp"
#include "reference/stokes_fem/boundary_labels.hpp"

#include <optional>
#include <span>
#include <variant>

namespace reference::stokes_fem {

/// Infinite cylinder.
struct Cylinder {
  pfv::Vec3 point;
  pfv::Vec3 direction; // unit
  double radius;
};

struct Plane {
  pfv::Vec3 normal; // unit
  double offset;    // normal . x on the plane
};

/// The geometry a piece of boundary approximates.
using ExactSurface = std::variant<Plane, pfv::Sphere, Cylinder>;

/// The exact surface of a label; `bridge_radius` in units of the smaller sphere's radius, as the mesher was told.
ExactSurface exact_surface(const BoundaryLabel& label, const pfv::Packing& packing, double bridge_radius);

/// Signed distance of a point from a surface, positive outside a sphere or cylinder.
double distance(const ExactSurface& surface, const pfv::Vec3& point);

/// The point on all the surfaces that is nearest to `start`, by Newton steps of least length; nothing when the steps do
/// not settle within `reach` of the start, as where surfaces are tangent.
std::optional<pfv::Vec3> project(const pfv::Vec3& start, std::span<const ExactSurface> surfaces, double reach);

} // namespace reference::stokes_fem
