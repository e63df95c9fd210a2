#pragma once

#include "pfv/grains/grains.hpp"

#include <cstdint>
#include <vector>

namespace pfv {

/// What a contact remembers.
enum class Bond : std::uint8_t { none, touching, cemented };

/// Pairs of grains that may touch, or come within reach of one another, before some grain or wall has moved by half of
/// `margin`, by the first of the two: those of grain i are start[i] ... start[i + 1] - 1, in ascending order of the
/// other. The reach is a share of the smaller radius.
struct CandidatePairs {
  std::vector<int> start;
  std::vector<int> other;
  std::vector<Vec3> image; // m, from the other to its image next to grain i; empty unless the box is periodic
  std::vector<Vec3> shear; // N, of the tangential spring, on the first
  std::vector<Bond> bond;
};

/// From grain i to the other of its pair e, or its image (m).
inline Vec3 apart(const CandidatePairs& pairs, int e, const Sphere& of_i, const Sphere& other) {
  const Vec3 between = other.centre - of_i.centre;
  return pairs.image.empty() ? between : between + pairs.image[e];
}

/// Grains that may touch a wall, by wall.
struct CandidateWalls {
  struct Contact {
    int grain;
    Vec3 shear; // N, on the grain
    Bond bond;
  };
  std::array<std::vector<Contact>, 6> of_face;
};

/// Linear in the number of grains: a grid of cells for each class of sizes, a class twice as coarse as the next, so
/// that few large grains do not make all cells large. What touches keeps its springs.
CandidatePairs candidate_pairs(const Grains& grains, double margin, const CandidatePairs& before = {},
                               double reach = 0);
CandidateWalls candidate_walls(const Grains& grains, double margin, const CandidateWalls& before = {},
                               double reach = 0);

} // namespace pfv
