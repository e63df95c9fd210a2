#include "pfv/pores/bars.hpp"

#include <algorithm>
#include <cmath>

namespace pfv {

Bars::Bars(const Packing& packing, double steps_per_sphere) : lower_(packing.box.lower) {
  constexpr double spheres_across = 2.75; // measured: 1.5 and 4.5 are slower
  const Vec3 size = packing.box.size();
  const double spheres = static_cast<double>(std::max<std::size_t>(packing.spheres.size(), 1));
  const double spacing = std::cbrt(size.prod() / spheres);
  const auto pieces = [](double count, double most) {
    return static_cast<std::size_t>(std::clamp(count, 1.0, std::max(most, 1.0)));
  };
  for (int axis = 0; axis < 2; ++axis) // no more bars than spheres, however flat the box is
    count_[axis] = pieces(size[axis] / (spheres_across * spacing), std::sqrt(spheres));
  const double bars = static_cast<double>(count_[0] * count_[1]);
  count_[2] = pieces(steps_per_sphere * size.z() / spacing, steps_per_sphere * spheres / bars); // likewise
  for (int axis = 0; axis < 3; ++axis)
    width_[axis] = size[axis] / static_cast<double>(count_[axis]);
}

} // namespace pfv
