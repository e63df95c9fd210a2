#include "pfv/problem/close_pairs.hpp"

#include <algorithm>

namespace pfv {

namespace {

/// Sphere numbers sorted by cell: those of cell c are order[start[c]] ... order[start[c + 1] - 1].
struct Cells {
  int across;
  std::vector<int> start, order;

  int number(int i, int j, int k) const { return (k * across + j) * across + i; }
};

Cells sort_into_cells(std::span<const Vec3> centres, double cell_size) {
  // More cells than spheres would only be empty.
  int most = 1;
  while (static_cast<std::size_t>(most) * most * most < centres.size())
    ++most;
  Cells cells{std::clamp(static_cast<int>(1 / cell_size), 1, most), {}, {}};
  const auto along = [&](double x) { return std::clamp(static_cast<int>(x * cells.across), 0, cells.across - 1); };
  std::vector<int> cell_of(centres.size());
  cells.start.assign(cells.across * cells.across * cells.across + 1, 0);
  for (std::size_t s = 0; s < centres.size(); ++s) {
    cell_of[s] = cells.number(along(centres[s].x()), along(centres[s].y()), along(centres[s].z()));
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

std::vector<ClosePair> close_pairs(std::span<const Vec3> centres, std::span<const double> radii, double reach) {
  const Cells cells = sort_into_cells(centres, 2 * std::ranges::max(radii) + reach);
  std::vector<ClosePair> pairs;
  const auto add_if_close = [&](int a, int b) {
    const double apart = radii[a] + radii[b] + reach;
    if (dot(centres[a] - centres[b], centres[a] - centres[b]) <= apart * apart)
      pairs.push_back({a, b});
  };
  const auto spheres_in = [&](int cell) {
    return std::span(cells.order).subspan(cells.start[cell], cells.start[cell + 1] - cells.start[cell]);
  };
  const auto in_box = [&](int i) { return i >= 0 && i < cells.across; };
  for (int k = 0; k < cells.across; ++k)
    for (int j = 0; j < cells.across; ++j)
      for (int i = 0; i < cells.across; ++i) {
        const int here = cells.number(i, j, k);
        for (int offset = 0; offset < 27; ++offset) {
          const int x = i + offset % 3 - 1, y = j + offset / 3 % 3 - 1, z = k + offset / 9 - 1;
          if (!in_box(x) || !in_box(y) || !in_box(z) || cells.number(x, y, z) > here)
            continue;
          for (const int a : spheres_in(here))
            for (const int b : spheres_in(cells.number(x, y, z)))
              if (cells.number(x, y, z) != here || b < a)
                add_if_close(a, b);
        }
      }
  return pairs;
}

} // namespace pfv
