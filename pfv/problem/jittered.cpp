#include "pfv/problem/generate.hpp"

#include <cstdint>

namespace pfv {

Packing jittered(Packing packing, double amplitude) {
  std::uint64_t state = 12345;
  for (Sphere& sphere : packing.spheres)
    for (int axis = 0; axis < 3; ++axis) {
      state = state * 6364136223846793005ULL + 1442695040888963407ULL; // Knuth, MMIX
      const double shift = amplitude * (static_cast<double>(state >> 11) / 4503599627370496.0 - 1);
      const double at = sphere.centre[axis] + shift;
      if (at > packing.box.lower[axis] && at < packing.box.upper[axis])
        sphere.centre[axis] = at;
    }
  return packing;
}

} // namespace pfv
