#pragma once

#include "pfv/grains/grains.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace pfv {

/// Some of the grains, sorted into the cells of a grid over the box. Grains beyond a wall count to the cells next to
/// it; along a periodic axis a grain counts where its image in the box is.
class Cells {
public:
  /// Cells at least `width` (m) wide.
  Cells(const Grains& grains, const std::vector<int>& members, double width);

  /// Hands every member that, or an image of which, may lie within `reach` of the point to `visit`, once.
  template <class Visit>
  void visit_around(const Vec3& point, double reach, const Visit& visit) const {
    std::array<Runs, 3> runs;
    for (int axis = 0; axis < 3; ++axis)
      runs[axis] = cells_within(axis, point[axis] - reach, point[axis] + reach);
    for (const auto& [x_first, x_last] : runs[0])
      for (int x = x_first; x <= x_last; ++x)
        for (const auto& [y_first, y_last] : runs[1])
          for (int y = y_first; y <= y_last; ++y)
            for (const auto& [z_first, z_last] : runs[2])
              visit_row(number(x, y, z_first), number(x, y, z_last), visit);
  }

private:
  struct Run {
    int first = 0, last = -1; // empty when last < first
  };
  /// Two where the cells around a point go on at the other end of a periodic axis.
  using Runs = std::array<Run, 2>;

  template <class Visit>
  void visit_row(int from, int to, const Visit& visit) const {
    for (int m = start_[from]; m < start_[std::max(from, to + 1)]; ++m)
      visit(members_[m]);
  }
  Runs cells_within(int axis, double from, double to) const;
  int cell_of(int axis, double place) const;
  int number(int x, int y, int z) const { return (x * count_[1] + y) * count_[2] + z; }

  PeriodicAxes periodic_;
  Vec3 lower_;
  std::array<int, 3> count_{};
  Vec3 per_length_;
  std::vector<int> start_, members_;
};

} // namespace pfv
