#pragma once

#include "pfv/problem/packing.hpp"
#include "pfv/problem/validate.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pfv {

/// What a packing file says, in its own unit of length, before it is validated.
struct SphereList {
  std::vector<Sphere> spheres;
  std::optional<Box> box;
  PackingOrigin origin;
  std::optional<PeriodicAxes> periodic = {}; // axes along which the file's box repeats, when it says so
  std::vector<std::string> notes = {};
};

/// A name under which files give the size of spheres, and what makes a radius of it.
struct SizeName {
  std::string_view name;
  double radius; // of a sphere whose size is 1
};

/// In the order in which they are looked for.
constexpr std::array<SizeName, 4> size_names{{{"radius", 1}, {"radii", 1}, {"r", 1}, {"diameter", 0.5}}};

} // namespace pfv
