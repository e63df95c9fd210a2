#include "reference/stokes_fem/curved_mapping.hpp"

#include <deal.II/fe/fe_simplex_p.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace reference::stokes_fem {

namespace {

using dealii::Point;
using dealii::Triangulation;
using Cell = Triangulation<3>::cell_iterator;

std::uint64_t edge_key(unsigned a, unsigned b) {
  return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | std::max(a, b);
}

// Which two vertices each of the support points 4 ... 9 of the quadratic tetrahedron lies between.
const std::array<std::pair<unsigned, unsigned>, 6>& edge_ends() {
  static const auto ends = [] {
    const dealii::FE_SimplexP<3> element(2);
    const auto& points = element.get_unit_support_points();
    std::array<std::pair<unsigned, unsigned>, 6> found;
    for (unsigned edge = 0; edge < 6; ++edge)
      for (unsigned a = 0; a < 4; ++a)
        for (unsigned b = 0; b < a; ++b)
          if (points[4 + edge].distance(points[a] + 0.5 * (points[b] - points[a])) < 1e-12)
            found[edge] = {a, b};
    return found;
  }();
  return ends;
}

std::vector<Point<3>> support_points(const Cell& cell, const CurvedEdges& edges) {
  std::vector<Point<3>> points;
  points.reserve(10);
  for (unsigned v = 0; v < 4; ++v)
    points.push_back(cell->vertex(v));
  for (const auto& [a, b] : edge_ends()) {
    const auto moved = edges.middle.find(edge_key(cell->vertex_index(a), cell->vertex_index(b)));
    points.push_back(moved != edges.middle.end() ? moved->second : points[a] + 0.5 * (points[b] - points[a]));
  }
  return points;
}

pfv::Vec3 as_vec3(const Point<3>& point) {
  return {point[0], point[1], point[2]};
}

// Gradients of the ten shape functions where a quadratic Jacobian is looked at: vertices, edge middles and centroid.
std::vector<std::array<dealii::Tensor<1, 3>, 10>> sampled_gradients() {
  const dealii::FE_SimplexP<3> element(2);
  std::vector<Point<3>> where = element.get_unit_support_points();
  where.emplace_back(0.25, 0.25, 0.25);
  std::vector<std::array<dealii::Tensor<1, 3>, 10>> gradients(where.size());
  for (std::size_t sample = 0; sample < where.size(); ++sample)
    for (unsigned node = 0; node < 10; ++node)
      gradients[sample][node] = element.shape_grad(node, where[sample]);
  return gradients;
}

double jacobian(const std::vector<Point<3>>& points, const std::array<dealii::Tensor<1, 3>, 10>& gradients) {
  dealii::Tensor<2, 3> derivative;
  for (unsigned node = 0; node < 10; ++node)
    derivative += outer_product(points[node], gradients[node]);
  return determinant(derivative);
}

bool is_folded(const Cell& cell, const CurvedEdges& edges) {
  static const auto samples = sampled_gradients();
  const auto points = support_points(cell, edges);
  const double straight = 6 * cell->measure();
  return std::ranges::any_of(samples, [&](const auto& at) { return jacobian(points, at) < 0.1 * straight; });
}

bool has_moved_edge(const Cell& cell, const CurvedEdges& edges) {
  return std::ranges::any_of(edge_ends(), [&](const auto& ends) {
    return edges.middle.contains(edge_key(cell->vertex_index(ends.first), cell->vertex_index(ends.second)));
  });
}

std::map<std::pair<unsigned, unsigned>, std::set<unsigned>> boundary_edges(const Triangulation<3>& mesh) {
  std::map<std::pair<unsigned, unsigned>, std::set<unsigned>> ids;
  for (const auto& face : mesh.active_face_iterators())
    if (face->at_boundary())
      for (unsigned v = 0; v < 3; ++v) {
        const unsigned a = face->vertex_index(v);
        const unsigned b = face->vertex_index((v + 1) % 3);
        ids[std::minmax(a, b)].insert(face->boundary_id());
      }
  return ids;
}

/// Moved edges that are images of each other, by the key of their vertices' numbers.
class EdgeImages {
public:
  EdgeImages(const CurvedEdges& edges, const std::vector<unsigned>& vertex_number) : vertex_number_(vertex_number) {
    for (const auto& [key, middle] : edges.middle)
      images_.emplace(numbered(static_cast<unsigned>(key >> 32), static_cast<unsigned>(key)), key);
  }

  void straighten(unsigned a, unsigned b, CurvedEdges& edges) const {
    const auto [begin, end] = images_.equal_range(numbered(a, b));
    for (auto image = begin; image != end; ++image)
      edges.middle.erase(image->second);
  }

  // An edge whose image could not be moved stays straight.
  void straighten_unmatched(const Triangulation<3>& mesh, const CurvedEdges& moved, CurvedEdges& edges) const {
    for (const auto& face : mesh.active_face_iterators())
      for (unsigned v = 0; face->at_boundary() && v < 3; ++v) {
        const unsigned a = face->vertex_index(v);
        const unsigned b = face->vertex_index((v + 1) % 3);
        if (!moved.middle.contains(edge_key(a, b)))
          straighten(a, b, edges);
      }
  }

private:
  std::uint64_t numbered(unsigned a, unsigned b) const { return edge_key(vertex_number_[a], vertex_number_[b]); }

  const std::vector<unsigned>& vertex_number_;
  std::unordered_multimap<std::uint64_t, std::uint64_t> images_;
};

void straighten(const Cell& cell, const EdgeImages& images, CurvedEdges& edges) {
  for (const auto& [a, b] : edge_ends())
    images.straighten(cell->vertex_index(a), cell->vertex_index(b), edges);
}

} // namespace

CurvedEdges curve_edges(const Triangulation<3>& mesh, const SurfaceById& surface,
                        const std::vector<unsigned>& vertex_number) {
  CurvedEdges edges;
  for (const auto& [ends, ids] : boundary_edges(mesh)) {
    std::vector<ExactSurface> surfaces;
    for (const unsigned id : ids)
      surfaces.push_back(surface(id));
    const pfv::Vec3 a = as_vec3(mesh.get_vertices()[ends.first]);
    const pfv::Vec3 b = as_vec3(mesh.get_vertices()[ends.second]);
    const double length = (b - a).norm();
    // A vertex off its surface means the mesher drew something else there; bending towards it would only do harm.
    const bool fits = std::ranges::all_of(surfaces, [&](const ExactSurface& exact) {
      return std::abs(distance(exact, a)) < 1e-3 * length && std::abs(distance(exact, b)) < 1e-3 * length;
    });
    const pfv::Vec3 half_way = (a + b) / 2;
    if (!fits)
      continue;
    const auto middle = project(half_way, surfaces, 0.25 * length);
    if (middle && (*middle - half_way).norm() > 1e-12 * length)
      edges.middle.emplace(edge_key(ends.first, ends.second), Point<3>((*middle)[0], (*middle)[1], (*middle)[2]));
  }

  const EdgeImages images(edges, vertex_number);
  images.straighten_unmatched(mesh, CurvedEdges(edges), edges);
  std::vector<Cell> curved;
  for (const auto& cell : mesh.active_cell_iterators())
    if (has_moved_edge(cell, edges))
      curved.push_back(cell);
  // A straightened edge changes the neighbours too, so until nothing more is folded.
  for (bool settled = false; !settled;) {
    settled = true;
    for (const Cell& cell : curved)
      if (has_moved_edge(cell, edges) && is_folded(cell, edges)) {
        straighten(cell, images, edges);
        ++edges.straightened_cells;
        settled = false;
      }
  }
  edges.cell_is_curved.assign(mesh.n_active_cells(), false);
  for (const Cell& cell : curved)
    if (has_moved_edge(cell, edges)) {
      edges.cell_is_curved[cell->active_cell_index()] = true;
      ++edges.curved_cells;
    }
  return edges;
}

CurvedEdges edges_in_part(const CurvedEdges& edges, const Triangulation<3>& part, const std::vector<unsigned>& vertex,
                          const std::vector<std::size_t>& cell) {
  CurvedEdges kept;
  for (const auto& here : part.active_cell_iterators()) {
    const bool is_curved = edges.cell_is_curved[cell[here->active_cell_index()]];
    kept.cell_is_curved.push_back(is_curved);
    kept.curved_cells += is_curved ? 1 : 0;
    for (const auto& [a, b] : edge_ends()) {
      const unsigned first = here->vertex_index(a);
      const unsigned second = here->vertex_index(b);
      if (const auto moved = edges.middle.find(edge_key(vertex[first], vertex[second])); moved != edges.middle.end())
        kept.middle.emplace(edge_key(first, second), moved->second);
    }
  }
  return kept;
}

CurvedMapping::CurvedMapping(std::shared_ptr<const CurvedEdges> edges)
    : dealii::MappingFE<3>(dealii::FE_SimplexP<3>(2)), edges_(std::move(edges)) {}

std::unique_ptr<dealii::Mapping<3>> CurvedMapping::clone() const {
  return std::make_unique<CurvedMapping>(*this);
}

bool CurvedMapping::is_curved(const Cell& cell) const {
  return edges_->cell_is_curved[cell->active_cell_index()];
}

std::vector<Point<3>> CurvedMapping::points(const Cell& cell) const {
  return support_points(cell, *edges_);
}

std::vector<Point<3>> CurvedMapping::compute_mapping_support_points(const Cell& cell) const {
  return support_points(cell, *edges_);
}

} // namespace reference::stokes_fem
