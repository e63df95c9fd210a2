#pragma once

#include <array>
#include <cstddef>

namespace reference::lattice_boltzmann {

/// The nineteen velocities of D3Q19 (Qian, d'Humieres and Lallemand 1992), numbered as Palabos does: rest, nine, and
/// in the same order their opposites.
inline constexpr std::size_t pairs = 9;
inline constexpr std::size_t directions = 19;
using Step = std::array<int, 3>;

inline constexpr std::array<Step, directions> steps{{{0, 0, 0},
                                                     {-1, 0, 0},
                                                     {0, -1, 0},
                                                     {0, 0, -1},
                                                     {-1, -1, 0},
                                                     {-1, 1, 0},
                                                     {-1, 0, -1},
                                                     {-1, 0, 1},
                                                     {0, -1, -1},
                                                     {0, -1, 1},
                                                     {1, 0, 0},
                                                     {0, 1, 0},
                                                     {0, 0, 1},
                                                     {1, 1, 0},
                                                     {1, -1, 0},
                                                     {1, 0, 1},
                                                     {1, 0, -1},
                                                     {0, 1, 1},
                                                     {0, 1, -1}}};

constexpr double weight(std::size_t direction) {
  return direction == 0 ? 1. / 3 : (direction - 1) % pairs < 3 ? 1. / 18 : 1. / 36;
}

constexpr std::size_t opposite(std::size_t direction) {
  return direction == 0 ? 0 : direction <= pairs ? direction + pairs : direction - pairs;
}

/// The direction of a step; nine steps of the twenty-seven have none and give `directions`.
constexpr std::size_t direction_of(const Step& step) {
  for (std::size_t d = 0; d < directions; ++d)
    if (steps[d] == step)
      return d;
  return directions;
}

} // namespace reference::lattice_boltzmann
