#include "pfv/pores/regular_cells.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Triangulation_cell_base_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pfv {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase =
    CGAL::Triangulation_vertex_base_with_info_3<Vertex, Kernel, CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
// What a hidden sphere is hidden by is not asked.
using BareCell = CGAL::Regular_triangulation_cell_base_3<Kernel, CGAL::Triangulation_cell_base_3<Kernel>,
                                                         CGAL::Discard_hidden_points>;
using CellBase = CGAL::Triangulation_cell_base_with_info_3<int, Kernel, BareCell>;
using Regular = CGAL::Regular_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
using Site = std::pair<Regular::Weighted_point, Vertex>;

std::vector<Site> sites_with_walls(std::span<const Sphere> spheres, const Vec3& size, const PeriodicAxes& periodic) {
  const double far_radius = std::exp2(23);
  // Ties between spheres and a wall must be broken alike in all images: by more than the curvature of the far sphere.
  const double set_back = std::ranges::find(periodic, true) != periodic.end() ? std::exp2(-22) : 0;
  const auto site = [](const Vec3& centre, double radius, Vertex vertex) {
    return Site{{{centre.x(), centre.y(), centre.z()}, radius * radius}, vertex};
  };
  std::vector<Site> sites;
  sites.reserve(spheres.size() + 6);
  for (std::size_t s = 0; s < spheres.size(); ++s)
    sites.push_back(site(spheres[s].centre, spheres[s].radius, static_cast<Vertex>(s)));
  for (const Face face : all_faces) {
    const int axis = index(axis_of(face));
    if (periodic[axis])
      continue;
    Vec3 centre = 0.5 * size;
    centre[axis] = (is_upper(face) ? size[axis] : 0) + (far_radius + set_back) * outward_normal(face)[axis];
    sites.push_back(site(centre, far_radius, wall_vertex(face)));
  }
  return sites;
}

Regular regular_triangulation(const std::vector<Site>& sites, Clock& clock) {
  const auto timing = clock.stage("triangulate");
  return {sites.begin(), sites.end()};
}

} // namespace

Triangulation regular_cells(std::span<const Sphere> spheres, const Vec3& size, const PeriodicAxes& periodic,
                            Clock& clock) {
  const auto sites = sites_with_walls(spheres, size, periodic);
  const Regular regular = regular_triangulation(sites, clock);

  Triangulation result;
  if (regular.dimension() < 3)
    return result;
  int count = 0;
  for (const auto cell : regular.all_cell_handles())
    cell->info() = regular.is_infinite(cell) ? Triangulation::outside : count++;
  result.cells.resize(count);
  result.neighbours.resize(count);
  const auto& cells = regular.tds().cells();
  auto ahead = cells.begin(); // what is read of the neighbours is on its way when its turn comes
  constexpr int far_ahead = 12;
  for (int k = 0; k < far_ahead && ahead != cells.end(); ++k)
    ++ahead;
  for (auto cell = cells.begin(); cell != cells.end(); ++cell) {
    if (ahead != cells.end()) {
      for (int v = 0; v < 4; ++v)
        __builtin_prefetch(&ahead->neighbor(v)->info());
      ++ahead;
    }
    if (cell->info() == Triangulation::outside)
      continue;
    for (int v = 0; v < 4; ++v) {
      result.cells[cell->info()][v] = cell->vertex(v)->info();
      result.neighbours[cell->info()][v] = cell->neighbor(v)->info();
    }
  }
  return result;
}

} // namespace pfv
