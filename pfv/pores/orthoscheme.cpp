#include "pfv/pores/orthoscheme.hpp"

#include "pfv/pores/lanes.hpp"

#include <algorithm>
#include <cmath>

namespace pfv {

OrthoschemePart ball_in_orthoscheme(double radius, double to_base, double along_base, double height) {
  const double a = std::abs(to_base), b = std::abs(along_base), h = std::abs(height);
  const double near = std::sqrt(a * a + b * b);
  const auto up_to =
      [&](double top) { // solid angle of k E R T, T at that height: Van Oosterom & Strackee 1983, eq. (8)
        return 2 * lanes::atan2(b * top, (near + std::sqrt(near * near + top * top)) * (near + a));
      };
  double angle = up_to(h), base = 0;
  if (a < radius) {
    const double disc = (radius - a) * (radius + a);                        // squared radius
    const double met = std::min(std::sqrt(std::max(0.0, disc - b * b)), h); // where the disc ends on R P
    const double sector = lanes::atan2(h, b) - lanes::atan2(met, b);
    angle -= up_to(met) + sector * (1 - a / radius);
    base = 0.5 * (b * met + disc * sector);
  }
  const double of_base = (along_base < 0) == (height < 0) ? 1 : -1, sign = to_base < 0 ? -of_base : of_base;
  return {sign * radius * radius * (radius * angle) / 3 + sign * a * base / 3, sign * radius * radius * angle,
          of_base * base};
}

} // namespace pfv
