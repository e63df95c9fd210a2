#pragma once

#include <cmath>
#include <string_view>
#include <variant>

namespace pfv {

// A rule gives the conductance K (m^3/(Pa s)) of a throat from S_f (m^2), the fluid part of its facet; Theta (m^3), the
// void between the facet and the centres of its two pores; gamma (m^2), the wetted surface in there; l (m), the
// distance of the centres; and mu (Pa s). A further rule is one more struct here and one more word in the variant.

/// K = alpha S_f R_h^2 / (mu l), R_h = Theta / gamma.
struct HydraulicRadius {
  static constexpr std::string_view name = "hydraulic-radius";
  static constexpr std::string_view source = "Catalano et al. 2011, eqs. (5)-(7)";
  double alpha = 0.5; // Hagen-Poiseuille in a circular tube

  double operator()(double fluid_area, double void_volume, double wetted_surface, double length,
                    double viscosity) const {
    const double radius = void_volume / wetted_surface;
    return alpha * fluid_area * radius * radius / (viscosity * length);
  }
};

/// The same with the geometric mean of the two areas at hand in place of S_f: that of the throat, and Theta / l, the
/// mean one between the centres. Where the throat is a tube both are one. A throat as wide as its pores lets less
/// through.
struct MixedArea {
  static constexpr std::string_view name = "mixed-area";
  static constexpr std::string_view source = "mean of S_f and Theta / l in Catalano et al. 2011, eq. (5)";
  double alpha = 0.5; // Hagen-Poiseuille in a circular tube

  double operator()(double fluid_area, double void_volume, double wetted_surface, double length,
                    double viscosity) const {
    const double radius = void_volume / wetted_surface;
    return alpha * std::sqrt(fluid_area * void_volume / length) * radius * radius / (viscosity * length);
  }
};

using Conductance = std::variant<HydraulicRadius, MixedArea>;

} // namespace pfv
