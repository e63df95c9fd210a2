#include "pfv/grains/candidates.hpp"

#include "pfv/grains/cells.hpp"

#include <algorithm>
#include <cmath>

namespace pfv {
namespace {

struct SizeClass {
  double largest; // m, radius
  Cells cells;
};

std::vector<SizeClass> size_classes(const Grains& grains, double margin, double reach) {
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
      classes.push_back({radius, Cells(grains, members[octave], (2 + reach) * radius + margin)});
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

CandidatePairs candidate_pairs(const Grains& grains, double margin, const CandidatePairs& before, double reach) {
  const auto classes = size_classes(grains, margin, reach);
  const auto farthest = [&](double a, double b) { return a + b + margin + reach * std::min(a, b); };
  const bool has_history = !before.start.empty();
  CandidatePairs pairs;
  pairs.start.reserve(grains.size() + 1);
  pairs.start.push_back(0);
  pairs.other.reserve(before.other.size() + before.other.size() / 8);
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const Sphere& a = grains.sphere(i);
    const auto first = static_cast<std::ptrdiff_t>(pairs.other.size());
    for (const SizeClass& of_size : classes)
      of_size.cells.visit_around(a.centre, farthest(a.radius, of_size.largest), [&](int j) {
        if (j <= static_cast<int>(i))
          return;
        const Sphere& b = grains.sphere(j);
        const double most = farthest(a.radius, b.radius);
        if ((b.centre + image_offset(grains, a.centre, b.centre) - a.centre).squaredNorm() < most * most)
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
  if (grains.is_periodic())
    for (std::size_t i = 0; i < grains.size(); ++i)
      for (int e = pairs.start[i]; e < pairs.start[i + 1]; ++e)
        pairs.image.push_back(image_offset(grains, grains.sphere(i).centre, grains.sphere(pairs.other[e]).centre));
  pairs.shear.assign(pairs.other.size(), Vec3::Zero());
  pairs.bond.assign(pairs.other.size(), Bond::none);
  if (has_history)
    for (std::size_t i = 0; i < grains.size(); ++i)
      take_over(before, i, pairs);
  return pairs;
}

CandidateWalls candidate_walls(const Grains& grains, double margin, const CandidateWalls& before, double reach) {
  CandidateWalls walls;
  for (const Face face : all_faces) {
    const int axis = index(axis_of(face));
    if (grains.periodic[axis])
      continue;
    const double wall = is_upper(face) ? grains.packing.box.upper[axis] : grains.packing.box.lower[axis];
    const auto& old = before.of_face[index(face)];
    auto known = old.begin();
    for (std::size_t i = 0; i < grains.size(); ++i) {
      const Sphere& sphere = grains.sphere(i);
      if (std::abs(sphere.centre[axis] - wall) - sphere.radius > margin + reach * sphere.radius)
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
