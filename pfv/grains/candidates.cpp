#include "pfv/grains/candidates.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pfv {
namespace {

/// The grains of one class of sizes, sorted into cells as wide as the largest pair of them and the margin.
class Cells {
public:
  Cells(const Grains& grains, const std::vector<int>& members, double width) {
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
      const auto c = cell_of(grains.sphere(i).centre);
      cell.push_back(number(c[0], c[1], c[2]));
      ++start_[cell.back() + 1];
    }
    for (std::size_t c = 1; c < start_.size(); ++c)
      start_[c] += start_[c - 1];
    members_.resize(members.size());
    std::vector<int> next(start_.begin(), start_.end() - 1);
    for (std::size_t m = 0; m < members.size(); ++m)
      members_[next[cell[m]]++] = members[m];
  }

  /// Hands every member that may lie within `reach` of the point to `visit`.
  template <class Visit>
  void visit_around(const Vec3& point, double reach, const Visit& visit) const {
    const auto from = cell_of(point - Vec3::Constant(reach)), to = cell_of(point + Vec3::Constant(reach));
    for (int x = from[0]; x <= to[0]; ++x)
      for (int y = from[1]; y <= to[1]; ++y) {
        const int last = start_[number(x, y, to[2]) + 1];
        for (int m = start_[number(x, y, from[2])]; m < last; ++m)
          visit(members_[m]);
      }
  }

private:
  std::array<int, 3> cell_of(const Vec3& point) const {
    std::array<int, 3> cell;
    for (int axis = 0; axis < 3; ++axis)
      cell[axis] =
          static_cast<int>(std::clamp((point[axis] - lower_[axis]) * per_length_[axis], 0.0, count_[axis] - 1.0));
    return cell;
  }
  int number(int x, int y, int z) const { return (x * count_[1] + y) * count_[2] + z; }

  Vec3 lower_;
  std::array<int, 3> count_{};
  Vec3 per_length_;
  std::vector<int> start_, members_;
};

struct SizeClass {
  double largest; // m, radius
  Cells cells;
};

std::vector<SizeClass> size_classes(const Grains& grains, double margin) {
  std::vector<std::vector<int>> members;
  double largest = 0;
  for (const Sphere& sphere : grains.packing.spheres)
    largest = std::max(largest, sphere.radius);
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const auto octave = static_cast<std::size_t>(std::log2(largest / grains.sphere(i).radius));
    if (members.size() <= octave)
      members.resize(octave + 1);
    members[octave].push_back(static_cast<int>(i));
  }
  std::vector<SizeClass> classes;
  for (std::size_t octave = 0; octave < members.size(); ++octave)
    if (!members[octave].empty()) {
      const double radius = std::ldexp(largest, -static_cast<int>(octave));
      classes.push_back({radius, Cells(grains, members[octave], 2 * radius + margin)});
    }
  return classes;
}

/// Springs and bonds of the pairs of grain i, both lists in ascending order; a bond whose grains are far apart is kept.
void take_over(const CandidatePairs& before, std::size_t i, CandidatePairs& pairs) {
  int old = before.start[i];
  const int last = before.start[i + 1];
  for (int e = pairs.start[i]; e < pairs.start[i + 1]; ++e) {
    while (old < last && before.other[old] < pairs.other[e])
      ++old;
    if (old < last && before.other[old] == pairs.other[e]) {
      pairs.shear[e] = before.shear[old];
      pairs.bond[e] = before.bond[old];
    }
  }
}

} // namespace

CandidatePairs candidate_pairs(const Grains& grains, double margin, const CandidatePairs& before) {
  const auto classes = size_classes(grains, margin);
  const bool has_history = !before.start.empty();
  CandidatePairs pairs;
  pairs.start.reserve(grains.size() + 1);
  pairs.start.push_back(0);
  pairs.other.reserve(before.other.size() + before.other.size() / 8);
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const Sphere& a = grains.sphere(i);
    const auto first = static_cast<std::ptrdiff_t>(pairs.other.size());
    for (const SizeClass& of_size : classes)
      of_size.cells.visit_around(a.centre, a.radius + of_size.largest + margin, [&](int j) {
        if (j <= static_cast<int>(i))
          return;
        const Sphere& b = grains.sphere(j);
        const double reach = a.radius + b.radius + margin;
        if ((b.centre - a.centre).squaredNorm() < reach * reach)
          pairs.other.push_back(j);
      });
    if (has_history)
      for (int e = before.start[i]; e < before.start[i + 1]; ++e)
        if (before.bond[e] == Bond::cemented &&
            std::find(pairs.other.begin() + first, pairs.other.end(), before.other[e]) == pairs.other.end())
          pairs.other.push_back(before.other[e]);
    std::sort(pairs.other.begin() + first, pairs.other.end());
    pairs.start.push_back(static_cast<int>(pairs.other.size()));
  }
  pairs.shear.assign(pairs.other.size(), Vec3::Zero());
  pairs.bond.assign(pairs.other.size(), Bond::none);
  if (has_history)
    for (std::size_t i = 0; i < grains.size(); ++i)
      take_over(before, i, pairs);
  return pairs;
}

CandidateWalls candidate_walls(const Grains& grains, double margin, const CandidateWalls& before) {
  CandidateWalls walls;
  for (const Face face : all_faces) {
    const int axis = index(axis_of(face));
    const double wall = is_upper(face) ? grains.packing.box.upper[axis] : grains.packing.box.lower[axis];
    const auto& old = before.of_face[index(face)];
    auto known = old.begin();
    for (std::size_t i = 0; i < grains.size(); ++i) {
      const Sphere& sphere = grains.sphere(i);
      if (std::abs(sphere.centre[axis] - wall) - sphere.radius > margin)
        continue;
      while (known != old.end() && known->grain < static_cast<int>(i))
        ++known;
      const bool had = known != old.end() && known->grain == static_cast<int>(i);
      walls.of_face[index(face)].push_back(
          had ? *known : CandidateWalls::Contact{static_cast<int>(i), Vec3::Zero(), Bond::none});
    }
  }
  return walls;
}

} // namespace pfv
