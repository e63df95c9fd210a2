#include "pfv/pores/bars.hpp"

#include <algorithm>
#include <cmath>

namespace pfv {

Bars::Bars(const Packing& packing) : lower_(packing.box.lower), length_(packing.box.size().z()) {
  constexpr double spheres_across = 2.75; // measured: 1.5 and 4.5 are slower
  const Vec3 size = packing.box.size();
  const double spheres = static_cast<double>(std::max<std::size_t>(packing.spheres.size(), 1));
  spacing_ = std::cbrt(size.prod() / spheres);
  for (int axis = 0; axis < 2; ++axis) { // no more bars than spheres, however flat the box is
    count_[axis] =
        static_cast<std::size_t>(std::clamp(size[axis] / (spheres_across * spacing_), 1.0, std::sqrt(spheres)));
    width_[axis] = size[axis] / static_cast<double>(count_[axis]);
  }
}

} // namespace pfv
