#pragma once

#include "pfv/pores/disc_part.hpp"

namespace pfv::testing {

/// Volume (m^3) and surface (m^2) of the part of a ball in a cone from its centre, inside the box.
struct BallPart {
  double volume = 0;
  double surface = 0;
};

/// The ball's part in the cone spanned by three directions; signed like the solid angle. Exact for any number of cuts:
/// the directions that leave through a wall before they reach the sphere give a flat-bottomed cone instead. It is how
/// throats were measured once, and by other formulas than now.
BallPart ball_in_cone(double radius, std::span<const WallCut> cuts, const Vec3& a, const Vec3& b, const Vec3& c);

} // namespace pfv::testing
