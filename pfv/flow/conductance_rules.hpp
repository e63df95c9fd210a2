#pragma once

#include "pfv/pores/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <variant>

namespace pfv {

/// What a throat conducts by.
struct ThroatShape {
  double fluid_area;     // m^2, S_f: the fluid part of its facet
  double void_volume;    // m^3, Theta: between the facet and the centres of its two pores
  double wetted_surface; // m^2, gamma: in there
  double length;         // m, l: distance of the centres
  double openness = 0;   // S_f / S; 0 for a rule that does not read openings
  double gap = 0;        // see smallest_gap; likewise
  double contrast = 0;   // see pore_contrast; likewise

  double hydraulic_radius() const { return void_volume / wetted_surface; } // m
};

// A rule gives the conductance K (m^3/(Pa s)) of a throat for a fluid of some viscosity (Pa s). A further rule is one
// more struct here and one more word in the variant. `shear_spread` is what goes with it in the viscous forces: the
// share in shear_spread.hpp, 0 where each throat pushes its own spheres alone.

/// K = alpha S_f R_h^2 / (mu l), R_h = Theta / gamma.
struct HydraulicRadius {
  static constexpr std::string_view name = "hydraulic-radius";
  static constexpr std::string_view source = "Catalano et al. 2011, eqs. (5)-(7)";
  static constexpr bool reads_openings = false;
  static constexpr double shear_spread = 0;
  double alpha = 0.5; // Hagen-Poiseuille in a circular tube

  double operator()(const ThroatShape& throat, double viscosity) const {
    const double radius = throat.hydraulic_radius();
    return alpha * throat.fluid_area * radius * radius / (viscosity * throat.length);
  }
};

/// The same with the geometric mean of the two areas at hand in place of S_f: that of the throat, and Theta / l, the
/// mean one between the centres. Where the throat is a tube both are one. A throat as wide as its pores lets less
/// through.
struct MixedArea {
  static constexpr std::string_view name = "mixed-area";
  static constexpr std::string_view source = "mean of S_f and Theta / l in Catalano et al. 2011, eq. (5)";
  static constexpr bool reads_openings = false;
  static constexpr double shear_spread = 0;
  double alpha = 0.5; // Hagen-Poiseuille in a circular tube

  double operator()(const ThroatShape& throat, double viscosity) const {
    const double radius = throat.hydraulic_radius();
    const double area = std::sqrt(throat.fluid_area * throat.void_volume / throat.length);
    return alpha * area * radius * radius / (viscosity * throat.length);
  }
};

/// The hydraulic radius corrected for how open the throat is,
///
///   K = alpha S_f R_h^2 / (mu l) (l / R_h)^(c_l s - c_g g / (g + g_h)) exp(-c_s (s - m) - c_p d (l - r) / (l + r)),
///
/// s = S_f / S and m = Theta / (S l), the fluid area of the throat and the mean one between the centres of its pores,
/// both over its whole area, g the smallest gap, d the contrast of the pores, r = (S l - 3 Theta) / gamma the mean
/// radius of what they wet.
///
/// A tight throat between touching spheres and like pores, all corrections 0, conducts as the paper says. One as wide
/// as its pores, s above m, conducts less: it does not take the pressure drop alone, and R_h counts only the spheres
/// inside it. Spheres that touch have dead corners between them; the tube's alpha is right with those, and too large as
/// soon as a gap opens them, as between the rods of a bundle, the wider the gap the less so. Both act along the throat,
/// the longer the more. Between a narrow pore and a wide one R_h is a mean that favours the wide one, so a long throat
/// conducts less, and a short one, which has no room to widen, more. K is positive and grows without end as l falls to
/// 0, where the centres coincide and d with them; square throats give the same however they are cut into triangles.
///
/// Fitted with `study calibrate` to Stokes flow through the packings of studies/throat_data, which says how far off it
/// is on each when it is fitted to all others, and so in its forces; studies/laws has packings that it has not seen.
struct Calibrated {
  static constexpr std::string_view name = "calibrated";
  static constexpr std::string_view source = "hydraulic-radius, fitted to finite elements in studies/throat_data";
  static constexpr bool reads_openings = true;
  double alpha = 0.5;          // Hagen-Poiseuille in a circular tube
  double openness = 3.333;     // c_s
  double length = 0.522;       // c_l
  double gap = 0.447;          // c_g
  double half_gap = 0.116;     // g_h, the gap that does half of what any can
  double contrast = 1.352;     // c_p
  double shear_spread = 0.353; // of what spheres bear, see ShearSpread

  static constexpr double least_solid_fraction = 0.3, largest_solid_fraction = 0.75, largest_radius_ratio = 5;
  static constexpr double permeability_error = 0.05; // relative, within that range: see permeability_error.hpp

  double operator()(const ThroatShape& throat, double viscosity) const {
    const double s = throat.openness, open = throat.fluid_area * throat.length;
    const double mean = s * throat.void_volume / open, solid = std::max(open - 3 * s * throat.void_volume, 0.0);
    const double along = throat.length * throat.wetted_surface;
    const double power = length * s - gap * throat.gap / (throat.gap + half_gap);
    const double widening = throat.contrast * (s * along - solid) / (s * along + solid);
    const double exponent =
        power * lanes::log(along / throat.void_volume) - openness * (s - mean) - contrast * widening;
    return lanes::exp(exponent) * HydraulicRadius{alpha}(throat, viscosity);
  }
};

using Conductance = std::variant<HydraulicRadius, MixedArea, Calibrated>;

/// Whether a rule reads the openness, the gap and the contrast of throats.
inline bool reads_openings(const Conductance& rule) {
  return std::visit([](const auto& chosen) { return chosen.reads_openings; }, rule);
}

/// What goes with a rule in the viscous forces.
inline double shear_spread(const Conductance& rule) {
  return std::visit([](const auto& chosen) { return chosen.shear_spread; }, rule);
}

} // namespace pfv
