#pragma once

#include "pfv/grains/lubrication.hpp"
#include "pfv/problem/vec3.hpp"

namespace pfv {

/// Two bodies and the film between them, seen from the first.
struct FilmBetween {
  Vec3 normal;   // to the second
  Vec3 sliding;  // m/s, of the second's surface over the first's in the middle of the gap, normal part included
  Vec3 spin;     // rad/s, of the first, less that of the second
  double radius; // m, harmonic mean a
  double skew;   // (r_1 - r_2) / (r_1 + r_2); -1 at a wall
};

/// What a film does to the first body; the second feels the opposite of both.
struct FilmLoad {
  Vec3 force;  // N, in the middle of the gap
  Vec3 couple; // N m
};

/// Each resistance against its motion. Rolling is the sum of both surfaces' velocities as the gap sees them, over a:
///
///   w_r = w_t - skew / a  n x s_t,
///
/// w_t and s_t being spin and sliding across the normal: where radii differ, the gap moves as one surface slides over
/// the other (Bagi & Kuhn, J. Appl. Mech. 71 (2004) 493). The load is the derivative of half of the dissipated power
///
///   R_n s_n^2 + R_s s_t^2 + R_r w_r^2 + R_t w_n^2,
///
/// so that it never adds energy, and vanishes when both bodies turn as one. With R_s = pi mu a ln, R_r = 3/5 pi mu a^3
/// ln these are the logarithms of Y^A, Y^B and Y^C of Jeffrey & Onishi (1984) at any ratio of the radii, and 8/15, 1/10
/// and 2/5 of a sphere at a plane (Goldman, Cox & Brenner, Chem. Eng. Sci. 22 (1967) 637).
inline FilmLoad film_load(const FilmResistance& resistance, const FilmBetween& film) {
  const double opening = film.sliding.dot(film.normal), twist = film.spin.dot(film.normal);
  const Vec3 sliding = film.sliding - opening * film.normal;
  const double lever = film.skew / film.radius;
  const Vec3 rolling = resistance.roll * (film.spin - twist * film.normal - lever * film.normal.cross(sliding));
  return {resistance.normal * opening * film.normal + resistance.shear * sliding - lever * rolling.cross(film.normal),
          -rolling - resistance.twist * twist * film.normal};
}

} // namespace pfv
