#include "pfv/pores/triangulate.hpp"

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

/// Moves cell i to place place[i].
template <typename T>
void arrange(std::vector<T>& values, const std::vector<int>& place) {
  std::vector<T> arranged(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    arranged[place[i]] = values[i];
  values = std::move(arranged);
}

void sort_cells(Triangulation& cells) {
  const auto first_sphere = [](const std::array<Vertex, 4>& vertices) {
    Vertex first = std::numeric_limits<Vertex>::max();
    for (const Vertex v : vertices)
      if (!is_wall(v))
        first = std::min(first, v);
    return first;
  };
  std::vector<int> start(cells.sites.size() + 1, 0);
  for (const auto& cell : cells.cells)
    ++start[first_sphere(cell) + 1];
  for (std::size_t s = 1; s < start.size(); ++s)
    start[s] += start[s - 1];
  std::vector<int> place(cells.cells.size());
  for (std::size_t i = 0; i < place.size(); ++i)
    place[i] = start[first_sphere(cells.cells[i])]++;
  for (auto& cell : cells.neighbours)
    for (int& neighbour : cell)
      if (neighbour != Triangulation::outside)
        neighbour = place[neighbour];
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

Triangulation triangulate(const Packing& packing, const PeriodicAxes& periodic) {
  const Packing scaled = in_units(packing);
  Triangulation cells;
  if (std::ranges::find(periodic, true) == periodic.end()) {
    Sites sites = sites_of(scaled);
    cells = regular_cells(sites.spheres, scaled.box.size(), periodic);
    cells.sites = std::move(sites);
  } else {
    cells = periodic_cells(scaled, periodic);
  }
  sort_cells(cells);
  find_hidden(cells, packing.spheres.size());
  move_sites(cells.sites, packing);
  return cells;
}

} // namespace pfv
