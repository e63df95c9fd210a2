#include "pfv/pores/triangulate.hpp"

#include "pfv/pores/bars.hpp"
#include "pfv/pores/periodic_cells.hpp"
#include "pfv/pores/regular_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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

/// Bar by bar and along each by the mean of the vertices: finer than the spheres, of which there are a sixth as many.
void sort_cells(Triangulation& cells, const Packing& packing) {
  constexpr double steps_per_sphere = 3;
  const Bars bars(packing);
  const std::size_t most = cells.cells.size() / bars.size() + 1;
  const std::size_t steps =
      std::clamp<std::size_t>(static_cast<std::size_t>(steps_per_sphere * bars.spheres_along()), 1, most);
  const auto step_of = [&](const std::array<Vertex, 4>& vertices) {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (const Vertex v : vertices)
      if (!is_wall(v)) {
        sum += cells.sites.spheres[v].centre;
        ++count;
      }
    const Vec3 mean = sum / count;
    return bars.of(mean) * steps + bars.step(mean, steps);
  };
  std::vector<int> start(bars.size() * steps + 1, 0);
  std::vector<int> place(cells.cells.size()); // first its step, then its place
  for (std::size_t i = 0; i < place.size(); ++i) {
    place[i] = static_cast<int>(step_of(cells.cells[i]));
    ++start[place[i] + 1];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  for (int& cell : place)
    cell = start[cell]++;
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
  sort_cells(cells, scaled);
  find_hidden(cells, packing.spheres.size());
  move_sites(cells.sites, packing);
  return cells;
}

} // namespace pfv
