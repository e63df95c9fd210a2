#include "pfv/pores/triangulate.hpp"

#include "pfv/pores/bars.hpp"
#include "pfv/pores/periodic_cells.hpp"
#include "pfv/pores/regular_cells.hpp"

#include <algorithm>
#include <cmath>

namespace pfv {
namespace {

/// Power of two next above the largest side: scaling by it is exact.
double unit_of(const Box& box) {
  return std::exp2(1 + std::ilogb(box.size().maxCoeff()));
}

Packing in_units(const Packing& packing) {
  const double unit = unit_of(packing.box);
  Packing scaled{{Vec3::Zero(), packing.box.size() / unit}, packing.spheres};
  for (auto& sphere : scaled.spheres)
    sphere = {(sphere.centre - packing.box.lower) / unit, sphere.radius / unit};
  return scaled;
}

/// Moves what is of cell i to place[i].
template <typename T>
void arrange(std::vector<T>& values, const std::vector<int>& place) {
  std::vector<T> arranged(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    arranged[place[i]] = values[i];
  values = std::move(arranged);
}

/// Bar by bar and along each by the mean of the vertices: finer than the spheres, of which there are a sixth as many.
void sort_cells(Triangulation& cells, const Packing& packing) {
  constexpr double steps_per_sphere = 3;
  const auto mean = [&](std::size_t i) -> Vec3 {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (const Vertex v : cells.cells[i])
      if (!is_wall(v)) {
        sum += cells.sites.spheres[v].centre;
        ++count;
      }
    return sum / count;
  };
  const auto place = Bars(packing, steps_per_sphere).places(cells.cells.size(), mean);
  for (auto& cell : cells.neighbours)
    for (int& neighbour : cell)
      neighbour = neighbour != Triangulation::outside ? place[neighbour] : Triangulation::outside;
  arrange(cells.cells, place);
  arrange(cells.neighbours, place);
  if (!cells.shifts.empty())
    arrange(cells.shifts, place);
}

void find_hidden(Triangulation& cells, std::size_t spheres) {
  std::vector<bool> seen(spheres, false);
  for (const auto& cell : cells.cells)
    for (const Vertex v : cell)
      if (!is_wall(v))
        seen[cells.sites.number[v]] = true;
  for (std::size_t k = 0; k < spheres; ++k)
    if (!seen[k])
      cells.hidden_spheres.push_back(static_cast<int>(k));
}

} // namespace

Triangulation triangulate(const Packing& packing, const PeriodicAxes& periodic, Clock& clock) {
  const Packing scaled = in_units(packing);
  Triangulation cells;
  if (std::ranges::find(periodic, true) == periodic.end()) {
    Sites sites = sites_of(scaled);
    cells = regular_cells(sites.spheres, scaled.box.size(), periodic, clock);
    cells.sites = std::move(sites);
  } else {
    cells = periodic_cells(scaled, periodic, clock);
  }
  sort_cells(cells, scaled);
  find_hidden(cells, packing.spheres.size());
  move_sites(cells.sites, packing);
  return cells;
}

} // namespace pfv
