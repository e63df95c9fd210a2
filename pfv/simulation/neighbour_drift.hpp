#pragma once

#include "pfv/problem/packing.hpp"

#include <array>
#include <span>
#include <vector>

namespace pfv {

/// How far the four bodies of a pore have moved against one another: what changes its shape. Moving together changes
/// nothing, be it that of a whole sample that settles.
class NeighbourDrift {
public:
  /// From here on.
  void start(const Packing& packing);

  /// Whether it is more (m) for some pore; `bodies` by pore, spheres and then walls by index(Face). Looks at pores only
  /// when grains have moved enough for it since it last did.
  bool exceeds(double allowed, const Packing& packing, std::span<const std::array<int, 4>> bodies);

private:
  double farthest(const Packing& packing, std::span<const std::array<int, 4>> bodies) const;

  Packing start_, looked_at_;
  double found_ = 0; // m, when last looked at
};

} // namespace pfv
