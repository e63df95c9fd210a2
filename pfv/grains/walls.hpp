#pragma once

#include "pfv/problem/face.hpp"
#include "pfv/problem/packing.hpp"

#include <array>
#include <string_view>
#include <variant>

namespace pfv {

// What the six faces of the box do to the grains. They are rigid planes; they move along their normal only.

struct FixedWall {
  bool operator==(const FixedWall&) const = default;
};

struct MovingWall {
  double velocity; // m/s, along the axis: positive towards larger coordinates

  bool operator==(const MovingWall&) const = default;
};

/// A piston of some mass, pressed into the box by a stress over its whole area and held back by grains and fluid.
struct LoadedWall {
  double stress; // Pa, into the box
  double mass;   // kg

  bool operator==(const LoadedWall&) const = default;
};

/// m^2.
inline double area_of(const Box& box, Face face) {
  const Vec3 size = box.size();
  return size.prod() / size[index(axis_of(face))];
}

using WallMotion = std::variant<FixedWall, MovingWall, LoadedWall>;

struct Walls {
  std::array<WallMotion, 6> motion; // by index(Face)
  PeriodicAxes periodic{};          // along these the box repeats: no walls, and none that moves
  double friction = 0;              // between grains and walls

  bool operator==(const Walls&) const = default;
};

} // namespace pfv
