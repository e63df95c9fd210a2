#include "reference/openfoam/disc.hpp"

#include <cmath>
#include <numbers>

namespace reference::openfoam {

double area_inside(const Disc& disc, const pfv::Box& box) {
  constexpr int rings = 64, angles = 256;
  // A point of a disc that lies in a face must not fall out of the box by round-off.
  const double slack = 1e-9 * box.size().maxCoeff();
  const pfv::Vec3 u = disc.normal.unitOrthogonal();
  const pfv::Vec3 v = disc.normal.cross(u);
  int inside = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const double r = disc.radius * std::sqrt((ring + 0.5) / rings);
    for (int step = 0; step < angles; ++step) {
      const double angle = 2 * std::numbers::pi * (step + 0.5) / angles;
      const pfv::Vec3 point = disc.centre + r * (std::cos(angle) * u + std::sin(angle) * v);
      inside += ((point - box.lower).array() >= -slack).all() && ((box.upper - point).array() >= -slack).all();
    }
  }
  return std::numbers::pi * disc.radius * disc.radius * inside / (rings * angles);
}

} // namespace reference::openfoam
