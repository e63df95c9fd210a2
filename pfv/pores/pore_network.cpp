#include "pfv/pores/pore_network.hpp"

#include "pfv/pores/pore_centres.hpp"
#include "pfv/pores/throat_geometry.hpp"
#include "pfv/pores/triangulate.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace pfv {
namespace {

Box without_end(Box box, const PeriodicAxes& periodic) {
  for (int axis = 0; axis < 3; ++axis)
    if (periodic[axis]) {
      box.lower[axis] = -std::numeric_limits<double>::infinity();
      box.upper[axis] = std::numeric_limits<double>::infinity();
    }
  return box;
}

/// Whether the throat through facet f of cell i is listed from this side: each is met from two.
bool is_first_side(const Triangulation& cells, int i, int f) {
  const int j = cells.neighbours[i][f];
  return j > i || (j == i && cells.shifts[i][f] > Shift{});
}

/// Those through a wall come last. Whether a facet is listed from a cell nobody can guess, so each is written down and
/// counted if it is.
void list_throats(const Triangulation& cells, PoreNetwork::Throats& throats) {
  const std::size_t most = 2 * cells.cells.size() + 4; // facets have two sides, but for those of walls
  throats.pores.resize(most);
  throats.facet.resize(most);
  throats.shift.resize(cells.shifts.empty() ? 0 : most);
  std::size_t count = 0;
  const auto list = [&](int i, int f, bool is_listed) {
    throats.pores[count] = {i, cells.neighbours[i][f]};
    throats.facet[count] = static_cast<std::uint8_t>(f);
    if (!cells.shifts.empty())
      throats.shift[count] = cells.shifts[i][f];
    count += is_listed ? 1 : 0;
  };
  const auto is_at_wall = [&](int i, int f) { return std::ranges::any_of(facet_opposite(cells.cells[i], f), is_wall); };
  std::vector<int> at_walls;
  for (int i = 0; i < static_cast<int>(cells.cells.size()); ++i) {
    const bool touches_wall = std::ranges::any_of(cells.cells[i], is_wall);
    if (touches_wall)
      at_walls.push_back(i);
    for (int f = 0; f < 4; ++f)
      list(i, f, is_first_side(cells, i, f) && !(touches_wall && is_at_wall(i, f)));
  }
  throats.interior = count;
  for (const int i : at_walls)
    for (int f = 0; f < 4; ++f)
      list(i, f, is_first_side(cells, i, f) && is_at_wall(i, f));
  throats.pores.resize(count);
  throats.facet.resize(count);
  throats.shift.resize(cells.shifts.empty() ? 0 : count);
  throats.wetted_parts.resize(count);
}

void list_wall_parts(PoreNetwork& network) {
  for (std::size_t i = 0; i < network.pores.vertices.size(); ++i)
    for (const Vertex v : network.pores.vertices[i])
      if (is_wall(v))
        network.wall_parts.push_back({static_cast<int>(i), face_of(v), 0});
}

PoreNetwork topology(const Packing& packing, const PeriodicAxes& periodic, Triangulation cells) {
  PoreNetwork network;
  network.box = packing.box;
  network.walls = without_end(packing.box, periodic);
  network.hidden_spheres = std::move(cells.hidden_spheres);
  list_throats(cells, network.throats);
  network.sites = std::move(cells.sites);
  network.pores.vertices = std::move(cells.cells);
  network.pores.centre.resize(network.pores.vertices.size());
  network.pores.volume.resize(network.pores.size());
  network.pores.void_volume.resize(network.pores.size());
  network.spheres.volume.resize(packing.spheres.size());
  network.spheres.wetted_surface.resize(packing.spheres.size());
  network.spheres.of_sites.resize(network.sites.size());
  list_wall_parts(network);
  return network;
}

} // namespace

PeriodicAxes PoreNetwork::periodic() const {
  return {std::isinf(walls.upper.x()), std::isinf(walls.upper.y()), std::isinf(walls.upper.z())};
}

bool PoreNetwork::Pores::touches(std::size_t pore, Face face) const {
  return std::ranges::find(vertices[pore], wall_vertex(face)) != vertices[pore].end();
}

void PoreNetwork::Throats::make_room_for_shapes(bool openings) {
  for (auto* const shape : {&fluid_area, &length, &void_volume, &wetted_surface})
    shape->resize(size());
  if (openings)
    for (auto* const opening : {&area, &gap, &contrast})
      opening->resize(size());
}

void PoreNetwork::Throats::forget_shapes() {
  for (auto* const shape : {&fluid_area, &length, &void_volume, &wetted_surface, &area, &gap, &contrast})
    *shape = std::vector<double>();
}

double PoreNetwork::porosity() const {
  return std::accumulate(pores.void_volume.begin(), pores.void_volume.end(), 0.0) / box.volume();
}

PoreNetwork build_pore_network(const Packing& packing, const PeriodicAxes& periodic, Clock& clock, bool openings) {
  Triangulation cells;
  {
    const auto timing = clock.stage("cells");
    cells = triangulate(packing, periodic, clock);
  }
  const auto timing = clock.stage("geometry");
  PoreNetwork network = topology(packing, periodic, std::move(cells));
  network.throats.make_room_for_shapes(openings);
  set_pore_centres(network);
  measure(network);
  return network;
}

void follow(PoreNetwork& network, const Packing& packing, Clock& clock) {
  assert(network.spheres.volume.size() == packing.spheres.size());
  const auto timing = clock.stage("geometry");
  network.walls = without_end(packing.box, network.periodic());
  network.box = packing.box;
  move_sites(network.sites, packing);
  set_pore_centres(network);
  measure(network);
}

} // namespace pfv
