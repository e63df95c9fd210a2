#include "pfv/pores/periodic_cells.hpp"

#include "pfv/pores/power_centre.hpp"
#include "pfv/pores/regular_cells.hpp"
#include "pfv/problem/error.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pfv {
namespace {

constexpr int most_layers = 100; // an image's shift is one byte

/// Coordinates on a grid fine enough not to matter and coarse enough that a shift by box sizes is exact, so that the
/// ties of a lattice are broken alike in all images.
double on_grid(double length) {
  return std::round(length * 0x1p49) * 0x1p-49;
}

Packing on_grid(Packing packing) {
  for (auto& sphere : packing.spheres)
    sphere.centre = sphere.centre.unaryExpr([](double x) { return on_grid(x); });
  packing.box.upper = packing.box.upper.unaryExpr([](double x) { return on_grid(x); });
  return packing;
}

/// Takes out spheres whose centres, or images, are one point of the grid with that of a larger one: they are hidden,
/// but which one of equals would be left to chance in each image.
void drop_coincident(Sites& sites, const Vec3& size, const PeriodicAxes& periodic) {
  const auto place = [&](int s) {
    std::array<double, 4> key{0, 0, 0, -sites.spheres[s].radius};
    for (int axis = 0; axis < 3; ++axis) {
      const double at = sites.spheres[s].centre[axis];
      key[axis] = periodic[axis] && at >= size[axis] ? at - size[axis] : at;
    }
    return key;
  };
  std::vector<int> order(sites.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, place);
  std::vector<bool> hidden(sites.size(), false);
  for (std::size_t n = 1; n < order.size(); ++n) {
    const auto before = place(order[n - 1]), here = place(order[n]);
    hidden[order[n]] = std::equal(here.begin(), here.begin() + 3, before.begin());
  }
  std::size_t count = 0;
  for (std::size_t s = 0; s < sites.size(); ++s)
    if (!hidden[s]) {
      sites.spheres[count] = sites.spheres[s];
      sites.number[count++] = sites.number[s];
    }
  sites.spheres.resize(count);
  sites.number.resize(count);
}

/// The sites of the packing and all their images at most `margin` outside the box.
Sites with_images(const Packing& packing, const PeriodicAxes& periodic, double margin) {
  const Vec3 size = packing.box.size();
  Sites sites = sites_of(packing);
  drop_coincident(sites, size, periodic);
  const std::size_t own = sites.size();
  sites.shift.assign(own, Shift{});
  std::array<int, 3> layers;
  for (int axis = 0; axis < 3; ++axis)
    layers[axis] = periodic[axis] ? static_cast<int>(std::ceil(margin / size[axis])) : 0;
  if (*std::ranges::max_element(layers) > most_layers)
    throw SolveError("the periodic box is too thin for its length: over 100 images side by side would be needed");
  const auto near = [&](const Vec3& centre) {
    for (int axis = 0; axis < 3; ++axis)
      if (periodic[axis] && (centre[axis] < -margin || centre[axis] > size[axis] + margin))
        return false;
    return true;
  };
  for (int z = -layers[2]; z <= layers[2]; ++z)
    for (int y = -layers[1]; y <= layers[1]; ++y)
      for (int x = -layers[0]; x <= layers[0]; ++x)
        for (std::size_t s = 0; s < own && (x != 0 || y != 0 || z != 0); ++s) {
          const Sphere image{sites.spheres[s].centre + Vec3(x, y, z).cwiseProduct(size), sites.spheres[s].radius};
          if (!near(image.centre))
            continue;
          sites.spheres.push_back(image);
          sites.number.push_back(sites.number[s]);
          sites.shift.push_back(
              {static_cast<std::int8_t>(x), static_cast<std::int8_t>(y), static_cast<std::int8_t>(z)});
        }
  return sites;
}

bool lower(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

/// The sphere among some vertices whose centre is lowest in x, then y, then z; -1 when all are walls.
template <std::size_t Count>
Vertex lowest(const Sites& sites, const std::array<Vertex, Count>& vertices) {
  Vertex first = -1;
  for (const Vertex v : vertices)
    if (!is_wall(v) && (first < 0 || lower(sites.spheres[v].centre, sites.spheres[first].centre)))
      first = v;
  return first;
}

/// Whether the sphere orthogonal to the vertices of a cell stays clear of all that lies beyond the margin.
bool is_certain(const Packing& packing, const PeriodicAxes& periodic, double margin, double largest_radius,
                const Sites& sites, const std::array<Vertex, 4>& cell) {
  const Vec3 centre = power_centre(packing.box, sites.spheres, cell).point;
  const Sphere& vertex = sites.spheres[lowest(sites, cell)];
  const double power = (centre - vertex.centre).squaredNorm() - vertex.radius * vertex.radius;
  const double reach = std::sqrt(std::max(0.0, power + largest_radius * largest_radius));
  for (int axis = 0; axis < 3; ++axis)
    if (periodic[axis] && (centre[axis] - reach < -margin || centre[axis] + reach > packing.box.upper[axis] + margin))
      return false;
  return true;
}

/// A facet whose cell beyond is an image of a kept one; `key` is the same on both sides.
struct OpenFacet {
  std::array<std::int64_t, 3> key;
  Shift origin; // of its lowest sphere
  int cell, facet;
};

OpenFacet open_facet(const Sites& sites, const std::array<Vertex, 3>& vertices, int cell, int facet) {
  OpenFacet result{{}, sites.shift[lowest(sites, vertices)], cell, facet};
  for (int c = 0; c < 3; ++c) {
    const Vertex v = vertices[c];
    if (is_wall(v)) {
      result.key[c] = v;
      continue;
    }
    std::int64_t code = sites.number[v];
    for (const std::int8_t along : sites.shift[v] - result.origin)
      code = code * 256 + along + 128;
    result.key[c] = code;
  }
  std::ranges::sort(result.key);
  return result;
}

/// Joins the cells on both sides of each open facet.
void join(std::vector<OpenFacet>& open, Triangulation& cells) {
  std::ranges::sort(open, {}, &OpenFacet::key);
  const auto fail = [] { throw SolveError("the triangulation of the periodic box does not repeat itself"); };
  if (open.size() % 2 != 0)
    fail();
  for (std::size_t n = 0; n < open.size(); n += 2) {
    const auto &a = open[n], &b = open[n + 1];
    if (a.key != b.key)
      fail();
    cells.neighbours[a.cell][a.facet] = b.cell;
    cells.neighbours[b.cell][b.facet] = a.cell;
    cells.shifts[a.cell][a.facet] = a.origin - b.origin;
    cells.shifts[b.cell][b.facet] = b.origin - a.origin;
  }
}

/// Keeps the cells whose lowest sphere is no image: one of each set of images.
Triangulation kept_once(const Triangulation& all, const Sites& sites) {
  Triangulation kept;
  std::vector<int> kept_as(all.cells.size(), Triangulation::outside);
  for (std::size_t i = 0; i < all.cells.size(); ++i)
    if (sites.shift[lowest(sites, all.cells[i])] == Shift{}) {
      kept_as[i] = static_cast<int>(kept.cells.size());
      kept.cells.push_back(all.cells[i]);
    }
  kept.neighbours.resize(kept.cells.size());
  kept.shifts.resize(kept.cells.size());
  std::vector<OpenFacet> open;
  for (std::size_t i = 0; i < all.cells.size(); ++i) {
    const int cell = kept_as[i];
    if (cell < 0)
      continue;
    for (int f = 0; f < 4; ++f) {
      const int beyond = all.neighbours[i][f];
      const auto& v = all.cells[i];
      const std::array<Vertex, 3> facet{v[(f + 1) % 4], v[(f + 2) % 4], v[(f + 3) % 4]};
      kept.neighbours[cell][f] = beyond < 0 ? Triangulation::outside : kept_as[beyond];
      if (kept.neighbours[cell][f] < 0 && lowest(sites, facet) >= 0)
        open.push_back(open_facet(sites, facet, cell, f));
    }
  }
  join(open, kept);
  return kept;
}

/// Drops the images that no cell needs.
void drop_unused(Triangulation& cells) {
  std::vector<int> used(cells.sites.size(), -1);
  for (std::size_t s = 0; s < used.size() && cells.sites.shift[s] == Shift{}; ++s)
    used[s] = 0;
  for (const auto& cell : cells.cells)
    for (const Vertex v : cell)
      if (!is_wall(v))
        used[v] = 0;
  int count = 0;
  for (std::size_t s = 0; s < used.size(); ++s)
    if (used[s] == 0) {
      used[s] = count;
      cells.sites.spheres[count] = cells.sites.spheres[s];
      cells.sites.number[count] = cells.sites.number[s];
      cells.sites.shift[count++] = cells.sites.shift[s];
    }
  cells.sites.spheres.resize(count);
  cells.sites.number.resize(count);
  cells.sites.shift.resize(count);
  for (auto& cell : cells.cells)
    for (Vertex& v : cell)
      if (!is_wall(v))
        v = used[v];
}

} // namespace

Triangulation periodic_cells(const Packing& in_units, const PeriodicAxes& periodic, Clock& clock) {
  const Packing packing = on_grid(in_units);
  double largest_radius = 0;
  for (const auto& sphere : packing.spheres)
    largest_radius = std::max(largest_radius, sphere.radius);
  const double spacing = std::cbrt(packing.box.volume() / static_cast<double>(packing.spheres.size()));
  const double widest = 4 * packing.box.size().norm();
  for (double margin = 2 * (spacing + largest_radius);; margin *= 2) {
    Sites sites = with_images(packing, periodic, margin);
    const Triangulation all = regular_cells(sites.spheres, packing.box.size(), periodic, clock);
    const auto uncertain = [&](const std::array<Vertex, 4>& cell) {
      return sites.shift[lowest(sites, cell)] == Shift{} &&
             !is_certain(packing, periodic, margin, largest_radius, sites, cell);
    };
    const bool flat = all.cells.empty(); // images of too few layers
    if (margin < widest && (flat || std::ranges::any_of(all.cells, uncertain)))
      continue;
    Triangulation kept = kept_once(all, sites);
    kept.sites = std::move(sites);
    drop_unused(kept);
    return kept;
  }
}

} // namespace pfv
