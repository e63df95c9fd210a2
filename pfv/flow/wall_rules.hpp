#pragma once

#include <array>
#include <string_view>
#include <variant>

namespace pfv {

// How a throat cut by a wall conducts.

/// The wall is a plane of symmetry: the throat is half of the one between the packing and its mirror image. S_f, Theta
/// and gamma are cut alike, R_h and l are those of the whole throat.
struct MirrorWalls {
  static constexpr std::string_view name = "mirror";
  static constexpr double surface = 0;               // of the wall's wetted area, counted in gamma
  static constexpr std::array factor{1.0, 1.0, 1.0}; // of the conductance, by number of walls
};

/// Fluid sticks to the wall: what it wets of the wall counts in gamma.
struct NoSlipWalls {
  static constexpr std::string_view name = "no-slip";
  static constexpr double surface = 1;
  static constexpr std::array factor{1.0, 1.0, 1.0};
};

/// What the original implementation (FlowEngine of YADE) does: the mirrored throat's conductance times 2^(-1/2) for one
/// wall and 1/2 for two. Kept for comparison only.
struct OriginalWalls {
  static constexpr std::string_view name = "original";
  static constexpr double surface = 0;
  static constexpr std::array factor{1.0, 0.70710678118654752440, 0.5};
};

using WallRule = std::variant<MirrorWalls, NoSlipWalls, OriginalWalls>;

} // namespace pfv
