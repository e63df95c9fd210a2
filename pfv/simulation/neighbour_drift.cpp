#include "pfv/simulation/neighbour_drift.hpp"

#include "pfv/problem/face.hpp"

#include <algorithm>
#include <cmath>

namespace pfv {
namespace {

Vec3 wall_move(const Box& from, const Box& to, Face face) {
  const int axis = index(axis_of(face));
  const Vec3 all = is_upper(face) ? to.upper - from.upper : to.lower - from.lower;
  return all[axis] * Vec3::Unit(axis);
}

/// m, the farthest that a grain or a wall has moved.
double farthest_alone(const Packing& from, const Packing& to) {
  double square = 0;
  for (std::size_t k = 0; k < from.spheres.size(); ++k)
    square = std::max(square, (to.spheres[k].centre - from.spheres[k].centre).squaredNorm());
  for (const Face face : all_faces)
    square = std::max(square, wall_move(from.box, to.box, face).squaredNorm());
  return std::sqrt(square);
}

} // namespace

void NeighbourDrift::start(const Packing& packing) {
  start_ = looked_at_ = packing;
  found_ = 0;
}

bool NeighbourDrift::exceeds(double allowed, const Packing& packing, std::span<const std::array<int, 4>> bodies) {
  if (found_ + 2 * farthest_alone(looked_at_, packing) <= allowed)
    return false;
  found_ = farthest(packing, bodies);
  looked_at_ = packing;
  return found_ > allowed;
}

double NeighbourDrift::farthest(const Packing& packing, std::span<const std::array<int, 4>> bodies) const {
  const auto spheres = static_cast<int>(packing.spheres.size());
  std::vector<Vec3> move;
  for (int k = 0; k < spheres; ++k)
    move.push_back(packing.spheres[k].centre - start_.spheres[k].centre);
  for (const Face face : all_faces)
    move.push_back(wall_move(start_.box, packing.box, face));
  double square = 0;
  for (const auto& pore : bodies)
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < a; ++b) {
        Vec3 apart = move[pore[a]] - move[pore[b]];
        const int last = std::max(pore[a], pore[b]);
        if (last >= spheres) // along a wall a grain may slide
          apart = apart[(last - spheres) / 2] * Vec3::Unit((last - spheres) / 2);
        square = std::max(square, std::min(pore[a], pore[b]) < spheres ? apart.squaredNorm() : 0);
      }
  return std::sqrt(square);
}

} // namespace pfv
