#include "pfv/pores/triangulate.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <cmath>
#include <utility>

namespace pfv {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase =
    CGAL::Triangulation_vertex_base_with_info_3<Vertex, Kernel, CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
using CellBase =
    CGAL::Triangulation_cell_base_with_info_3<int, Kernel, CGAL::Regular_triangulation_cell_base_3<Kernel>>;
using Regular = CGAL::Regular_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
using Site = std::pair<Regular::Weighted_point, Vertex>;

/// Power of two next above the largest side: scaling by it is exact.
double unit_of(const Box& box) {
  return std::exp2(1 + std::ilogb(box.size().maxCoeff()));
}

std::vector<Site> sites_of(const Packing& packing) {
  const double unit = unit_of(packing.box);
  const double far_radius = std::exp2(23);
  const auto site = [](const Vec3& centre, double radius, Vertex vertex) {
    return Site{{{centre.x(), centre.y(), centre.z()}, radius * radius}, vertex};
  };
  std::vector<Site> sites;
  sites.reserve(packing.spheres.size() + 6);
  for (std::size_t k = 0; k < packing.spheres.size(); ++k) {
    const auto& sphere = packing.spheres[k];
    sites.push_back(site((sphere.centre - packing.box.lower) / unit, sphere.radius / unit, static_cast<Vertex>(k)));
  }
  const Vec3 size = packing.box.size() / unit;
  for (const Face face : all_faces) {
    const Vec3 foot = is_upper(face) ? size : Vec3::Zero();
    Vec3 centre = 0.5 * size;
    const int axis = index(axis_of(face));
    centre[axis] = foot[axis] + far_radius * outward_normal(face)[axis];
    sites.push_back(site(centre, far_radius, wall_vertex(face)));
  }
  return sites;
}

} // namespace

Triangulation triangulate(const Packing& packing) {
  const auto sites = sites_of(packing);
  const Regular regular(sites.begin(), sites.end());

  Triangulation result;
  int count = 0;
  for (const auto cell : regular.all_cell_handles())
    cell->info() = regular.is_infinite(cell) ? Triangulation::outside : count++;
  result.cells.resize(count);
  result.neighbours.resize(count);
  for (const auto cell : regular.finite_cell_handles()) {
    for (int v = 0; v < 4; ++v) {
      result.cells[cell->info()][v] = cell->vertex(v)->info();
      result.neighbours[cell->info()][v] = cell->neighbor(v)->info();
    }
  }

  std::vector<bool> seen(packing.spheres.size(), false);
  for (const auto vertex : regular.finite_vertex_handles())
    if (!is_wall(vertex->info()))
      seen[vertex->info()] = true;
  for (std::size_t k = 0; k < seen.size(); ++k)
    if (!seen[k])
      result.hidden_spheres.push_back(static_cast<int>(k));
  return result;
}

} // namespace pfv
