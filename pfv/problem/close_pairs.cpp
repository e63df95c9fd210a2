#include "pfv/problem/close_pairs.hpp"

#include <algorithm>

namespace pfv {

namespace {

/// Sphere numbers sorted by cell: those of cell c are order[start[c]] ... order[start[c + 1] - 1].
struct Cells {
  int across;
  std::vector<int> start, order;

  int number(int i, int j, int k) const { return (k * across + j) * across + i; }

  /// A cell's number along an axis and those of its neighbours, each once.
  std::vector<int> around(int i, bool periodic) const {
    std::vector<int> found;
    for (int other = i - 1; other <= i + 1; ++other) {
      const int wrapped = periodic ? (other + across) % across : other;
      if (wrapped >= 0 && wrapped < across && std::ranges::find(found, wrapped) == found.end())
        found.push_back(wrapped);
    }
    return found;
  }
};

Cells sort_into_cells(std::span<const Vec3> centres, double cell_size, const PeriodicAxes& periodic) {
  // More cells than spheres would only be empty.
  int most = 1;
  while (static_cast<std::size_t>(most) * most * most < centres.size())
    ++most;
  Cells cells{std::clamp(static_cast<int>(1 / cell_size), 1, most), {}, {}};
  const auto along = [&](const Vec3& centre, int axis) {
    const double x = periodic[axis] ? centre[axis] - std::floor(centre[axis]) : centre[axis];
    return std::clamp(static_cast<int>(x * cells.across), 0, cells.across - 1);
  };
  std::vector<int> cell_of(centres.size());
  cells.start.assign(cells.across * cells.across * cells.across + 1, 0);
  for (std::size_t s = 0; s < centres.size(); ++s) {
    cell_of[s] = cells.number(along(centres[s], 0), along(centres[s], 1), along(centres[s], 2));
    ++cells.start[cell_of[s] + 1];
  }
  for (std::size_t c = 1; c < cells.start.size(); ++c)
    cells.start[c] += cells.start[c - 1];
  cells.order.resize(centres.size());
  std::vector<int> next(cells.start.begin(), cells.start.end() - 1);
  for (std::size_t s = 0; s < centres.size(); ++s)
    cells.order[next[cell_of[s]]++] = static_cast<int>(s);
  return cells;
}

} // namespace

std::vector<ClosePair> close_pairs(std::span<const Vec3> centres, std::span<const double> radii, double reach,
                                   const PeriodicAxes& periodic) {
  const Cells cells = sort_into_cells(centres, 2 * std::ranges::max(radii) + reach, periodic);
  std::vector<ClosePair> pairs;
  const auto add_if_close = [&](int a, int b) {
    const double apart = radii[a] + radii[b] + reach;
    const Vec3 difference = nearest_image(centres[a] - centres[b], periodic);
    if (dot(difference, difference) <= apart * apart)
      pairs.push_back({a, b});
  };
  const auto spheres_in = [&](int cell) {
    return std::span(cells.order).subspan(cells.start[cell], cells.start[cell + 1] - cells.start[cell]);
  };
  const auto add_pairs_of = [&](int here, int there) {
    for (const int a : spheres_in(here))
      for (const int b : spheres_in(there))
        if (there != here || b < a)
          add_if_close(a, b);
  };
  for (int k = 0; k < cells.across; ++k)
    for (int j = 0; j < cells.across; ++j)
      for (int i = 0; i < cells.across; ++i) {
        const int here = cells.number(i, j, k);
        for (const int z : cells.around(k, periodic[2]))
          for (const int y : cells.around(j, periodic[1]))
            for (const int x : cells.around(i, periodic[0]))
              if (const int there = cells.number(x, y, z); there <= here)
                add_pairs_of(here, there);
      }
  return pairs;
}

} // namespace pfv
