#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

namespace pfv {

/// Motions of two surfaces past one another: along the normal; along the gap; rolling, which drags fluid through it;
/// spin about the normal.
enum class FilmMotion { normal, shear, roll, twist };

inline constexpr std::array<FilmMotion, 4> all_film_motions{FilmMotion::normal, FilmMotion::shear, FilmMotion::roll,
                                                            FilmMotion::twist};
inline constexpr std::array<std::string_view, 4> film_motion_names{"normal", "shear", "roll", "twist"};

/// Films of fluid between grains, and between grains and walls, that are nearer than the pores of the flow can see.
struct Lubrication {
  double viscosity;        // Pa s
  double roughness = 0.01; // no gap counts as smaller than this share of the smaller radius
  double reach = 0.5;      // and beyond this share there is no film
  std::vector<FilmMotion> resists{all_film_motions.begin(), all_film_motions.end()};

  bool operator==(const Lubrication&) const = default;
};

/// Force by velocity and couple by spin.
struct FilmResistance {
  double normal = 0, shear = 0; // N s/m
  double roll = 0, twist = 0;   // N m s
};

/// Of a film of thickness h (m) between spheres whose radii have the harmonic mean a = 2 r_1 r_2 / (r_1 + r_2), so that
/// a wall is a sphere of infinite radius and a = 2 r there.
///
///   normal  3/2 pi mu a^2 / h
///   shear   pi mu (- a + (a + h/2) ln((2 a + h) / h))
///   roll    pi mu a^3 (3/5 + 63/125 h/a) ln(a / h)
///   twist   pi mu a^2 (zeta(3) a - h ln(a / h))
///
/// Normal and shear: Marzougui, Chareyre & Chauchat, Granular Matter 17 (2015) 447, after Frankel & Acrivos (1967). All
/// have the singular terms of Jeffrey & Onishi, J. Fluid Mech. 139 (1984) 261, at any ratio of the radii (see
/// film_load). Two differ from what is usually coded beside them, as by the original implementation: roll has 3/2 and
/// 63/500 there (3/20 and 63/500 with its pores) where J. & O., 8 pi mu a^3 (Y^C_11 - Y^C_12) / 2, give 3/5 and 63/125;
/// and twist is + pi mu a^2 h ln(a / h), the second term alone and with the other sign, where the spin of one sphere
/// turns the other by 8 pi mu a^3 X^C_12.
inline FilmResistance film_resistance(double viscosity, double a, double h) {
  constexpr double zeta_3 = 1.2020569031595942;
  const double scale = std::numbers::pi * viscosity, logarithm = std::log(a / h);
  return {1.5 * scale * a * a / h, scale * (-a + (a + 0.5 * h) * std::log((2 * a + h) / h)),
          scale * a * a * (0.6 * a + 0.504 * h) * logarithm, scale * a * a * (zeta_3 * a - h * logarithm)};
}

} // namespace pfv
