#include "pfv/grains/cells.hpp"

#include <cmath>

namespace pfv {

Cells::Cells(const Grains& grains, const std::vector<int>& members, double width) : periodic_(grains.periodic) {
  const Box& box = grains.packing.box;
  lower_ = box.lower;
  const double most = std::cbrt(8.0 * static_cast<double>(members.size()) + 64);
  for (int axis = 0; axis < 3; ++axis) {
    const double length = box.upper[axis] - box.lower[axis];
    count_[axis] = static_cast<int>(std::clamp(std::floor(length / width), 1.0, most));
    per_length_[axis] = count_[axis] / length;
  }
  start_.assign(static_cast<std::size_t>(count_[0]) * count_[1] * count_[2] + 1, 0);
  std::vector<int> cell;
  cell.reserve(members.size());
  for (const int i : members) {
    const Vec3& centre = grains.sphere(i).centre;
    cell.push_back(number(cell_of(0, centre.x()), cell_of(1, centre.y()), cell_of(2, centre.z())));
    ++start_[cell.back() + 1];
  }
  for (std::size_t c = 1; c < start_.size(); ++c)
    start_[c] += start_[c - 1];
  members_.resize(members.size());
  std::vector<int> next(start_.begin(), start_.end() - 1);
  for (std::size_t m = 0; m < members.size(); ++m)
    members_[next[cell[m]]++] = members[m];
}

int Cells::cell_of(int axis, double place) const {
  const double cell = (place - lower_[axis]) * per_length_[axis];
  if (!periodic_[axis])
    return static_cast<int>(std::clamp(cell, 0.0, count_[axis] - 1.0));
  const double wrapped = std::floor(cell) - count_[axis] * std::floor(cell / count_[axis]);
  return std::clamp(static_cast<int>(wrapped), 0, count_[axis] - 1);
}

Cells::Runs Cells::cells_within(int axis, double from, double to) const {
  const int first = cell_of(axis, from), last = cell_of(axis, to), end = count_[axis] - 1;
  if (!periodic_[axis])
    return {{{first, last}, {}}};
  const double across = (to - from) * per_length_[axis];
  if (across >= count_[axis] - 1)
    return {{{0, end}, {}}};
  if (first <= last)
    return {{{first, last}, {}}};
  return {{{0, last}, {first, end}}};
}

} // namespace pfv
