#include "solid_angle.hpp"

#include <cmath>

namespace pfv {

double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double na = a.norm(), nb = b.norm(), nc = c.norm();
  const double numerator = a.dot(b.cross(c));
  const double denominator = na * nb * nc + a.dot(b) * nc + a.dot(c) * nb + b.dot(c) * na;
  return 2 * std::atan2(numerator, denominator);
}

} // namespace pfv
