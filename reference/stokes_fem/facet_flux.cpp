#include "reference/stokes_fem/facet_flux.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace reference::stokes_fem {

namespace {

using pfv::Vec3;

constexpr double flat = 1e-12; // of the unit of length, which is the longest side of the box

/// A point of a cut, with its place in the straight cell.
struct CutPoint {
  Vec3 at;
  Weights weights;
};
using Cut = std::vector<CutPoint>; // convex polygon

CutPoint between(const CutPoint& a, const CutPoint& b, double share) {
  return {a.at + share * (b.at - a.at), a.weights + share * (b.weights - a.weights)};
}

Vec3 area_vector(const Probes::Facet& facet) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < facet.size(); ++i)
    sum += (facet[i] - facet[0]).cross(facet[i + 1] - facet[0]) / 2;
  return sum;
}

/// The facet's plane; a point on it belongs to the side above or below.
struct CutPlane {
  Vec3 normal;
  double offset;
  bool above_itself = true;

  double height(const Vec3& point) const {
    const double value = normal.dot(point) - offset;
    return std::abs(value) < flat ? 0 : value;
  }
  bool is_above(double height) const { return height == 0 ? above_itself : height > 0; }
};

CutPlane plane_of(const Probes::Facet& facet, const Vec3& normal, const pfv::Box& box,
                  const pfv::PeriodicAxes& periodic) {
  CutPlane plane{normal, normal.dot(facet[0])};
  for (const pfv::Face face : pfv::all_faces) {
    const int axis = index(axis_of(face));
    const double end = (is_upper(face) ? box.upper : box.lower)[axis];
    const bool inwards = (normal[axis] > 0) != is_upper(face);
    if (inwards && !periodic[static_cast<std::size_t>(axis)] &&
        std::ranges::all_of(facet, [&](const Vec3& p) { return std::abs(p[axis] - end) < flat; }))
      plane.above_itself = false;
  }
  return plane;
}

/// The polygon in which a plane meets a straight tetrahedron.
Cut cut_by(const CutPlane& plane, const std::array<CutPoint, 4>& corners) {
  std::array<double, 4> height{};
  std::array<std::size_t, 4> order{}; // those above, then those below
  std::size_t above = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    height[i] = plane.height(corners[i].at);
    if (plane.is_above(height[i]))
      order[above++] = i;
  }
  for (std::size_t i = 0, next = above; i < 4; ++i)
    if (!plane.is_above(height[i]))
      order[next++] = i;
  const auto crossing = [&](std::size_t i, std::size_t j) {
    const std::size_t a = order[i];
    const std::size_t b = order[j];
    return between(corners[a], corners[b], height[a] / (height[a] - height[b]));
  };
  if (above == 1)
    return {crossing(0, 1), crossing(0, 2), crossing(0, 3)};
  if (above == 2)
    return {crossing(0, 2), crossing(0, 3), crossing(1, 3), crossing(1, 2)};
  if (above == 3)
    return {crossing(0, 3), crossing(1, 3), crossing(2, 3)};
  return {};
}

/// What of a polygon lies where inward.(x - corner) >= 0 (Sutherland and Hodgman 1974).
Cut clipped(const Cut& polygon, const Vec3& corner, const Vec3& inward) {
  Cut kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const CutPoint& here = polygon[i];
    const CutPoint& next = polygon[(i + 1) % polygon.size()];
    const double inside_here = inward.dot(here.at - corner);
    const double inside_next = inward.dot(next.at - corner);
    if (inside_here >= 0)
      kept.push_back(here);
    if ((inside_here >= 0) != (inside_next >= 0))
      kept.push_back(between(here, next, inside_here / (inside_here - inside_next)));
  }
  return kept;
}

/// Straight tetrahedra between the ten nodes of a quadratic one: four at the corners, four around the octahedron's
/// diagonal between the middles of two opposite edges.
constexpr std::array<std::array<int, 4>, 8> eighths{
    {{0, 4, 6, 7}, {4, 1, 5, 8}, {6, 5, 2, 9}, {7, 8, 9, 3}, {4, 9, 5, 6}, {4, 9, 6, 7}, {4, 9, 7, 8}, {4, 9, 8, 5}}};

class Facet {
public:
  Facet(const FlowMesh& mesh, const Probes::Facet& corners, const Vec3& normal, const CutPlane& plane)
      : mesh_(mesh), corners_(corners), normal_(normal), plane_(plane) {}

  double flux_in(std::size_t index) const {
    const QuadraticCell cell = mesh_.cell(index);
    if (!mesh_.is_curved[index])
      return flux_in_tetrahedron(index, cell, {0, 1, 2, 3});
    double sum = 0;
    for (const auto& nodes : eighths)
      sum += flux_in_tetrahedron(index, cell, nodes);
    return sum;
  }

private:
  double flux_in_tetrahedron(std::size_t index, const QuadraticCell& cell, const std::array<int, 4>& nodes) const {
    std::array<CutPoint, 4> points;
    for (std::size_t i = 0; i < 4; ++i)
      points[i] = {cell.points[static_cast<std::size_t>(nodes[i])], QuadraticCell::node(nodes[i])};
    Cut cut = cut_by(plane_, points);
    for (std::size_t side = 0; side < corners_.size() && !cut.empty(); ++side)
      cut = clipped(cut, corners_[side], normal_.cross(corners_[(side + 1) % corners_.size()] - corners_[side]));
    double sum = 0;
    for (std::size_t i = 1; i + 1 < cut.size(); ++i)
      sum += flux_in_triangle(index, cell, cut[0], cut[i], cut[i + 1]);
    return sum;
  }

  double flux_in_triangle(std::size_t index, const QuadraticCell& cell, const CutPoint& a, const CutPoint& b,
                          const CutPoint& c) const {
    const double area = (b.at - a.at).cross(c.at - a.at).norm() / 2;
    double sum = 0;
    for (const Vec3& share : {Vec3(4, 1, 1), Vec3(1, 4, 1), Vec3(1, 1, 4)}) {
      Weights weights = (share[0] * a.weights + share[1] * b.weights + share[2] * c.weights) / 6;
      if (mesh_.is_curved[index])
        weights = cell.weights_of((share[0] * a.at + share[1] * b.at + share[2] * c.at) / 6, weights).value_or(weights);
      sum += normal_.dot(mesh_.velocity_at(index, weights));
    }
    return sum / 3 * area;
  }

  const FlowMesh& mesh_;
  const Probes::Facet& corners_;
  Vec3 normal_;
  CutPlane plane_;
};

} // namespace

double facet_flux(const FlowMesh& mesh, const CellSearch& search, const Probes::Facet& corners, const pfv::Box& box,
                  const pfv::PeriodicAxes& periodic) {
  const Vec3 area = area_vector(corners);
  if (!(area.norm() > 0))
    return 0;
  Vec3 lower = corners[0];
  Vec3 upper = corners[0];
  for (const Vec3& corner : corners) {
    lower = lower.cwiseMin(corner);
    upper = upper.cwiseMax(corner);
  }
  const Vec3 normal = area.normalized();
  const Facet facet(mesh, corners, normal, plane_of(corners, normal, box, periodic));
  double sum = 0;
  for (const std::size_t cell : search.near(lower, upper))
    sum += facet.flux_in(cell);
  return sum;
}

} // namespace reference::stokes_fem
