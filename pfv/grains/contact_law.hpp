#pragma once

#include <cmath>
#include <string_view>
#include <variant>

namespace pfv {

// What two grains, or a grain and a wall, oppose to their overlap and to their relative motion along the contact.
// Normal and tangential springs with Coulomb's limit: Cundall & Strack, Geotechnique 29 (1979) 47.
//
// A law is a struct of parameters with a function `springs(radius, overlap)`, radius being r_i r_j / (r_i + r_j), at a
// wall r_i: walls are flat, of the grains' material.

struct Springs {
  double force;      // N, normal, repulsive when positive
  double normal;     // N/m, d force / d overlap
  double tangential; // N/m
  double energy;     // J, stored in the normal spring
};

struct Friction {
  double coefficient = 0.5;
  double damping = 0; // of the normal motion, as a share of the critical one

  bool operator==(const Friction&) const = default;
};

/// Springs in proportion to the grain: k_n = 2 E r_i r_j / (r_i + r_j), so that a packing behaves alike at any size.
struct LinearSprings {
  static constexpr std::string_view name = "linear";
  double young = 1e7;            // Pa
  double tangential_ratio = 0.5; // k_t / k_n
  Friction friction;

  Springs springs(double radius, double overlap) const {
    const double k = 2 * young * radius;
    return {k * overlap, k, tangential_ratio * k, 0.5 * k * overlap * overlap};
  }
  bool operator==(const LinearSprings&) const = default;
};

/// The same springs for every pair.
struct ConstantSprings {
  static constexpr std::string_view name = "constant";
  double normal = 1e5;     // N/m
  double tangential = 5e4; // N/m
  Friction friction;

  Springs springs(double, double overlap) const {
    return {normal * overlap, normal, tangential, 0.5 * normal * overlap * overlap};
  }
  bool operator==(const ConstantSprings&) const = default;
};

/// Elastic spheres: Hertz (1882), and Mindlin (1949) for the tangential stiffness. Same material on both sides. The
/// shear force grows by that stiffness times the sliding and is kept while the overlap changes (LAMMPS calls this
/// mindlin/force), so that a normal load that swings is reversible; a contact that is sheared pressed and then opened
/// gives back more than it took. Measured: 0.6 % of the work of all loads in a shaken packing.
struct HertzMindlin {
  static constexpr std::string_view name = "hertz";
  double young = 1e9;   // Pa
  double poisson = 0.3; // of the grains' material
  Friction friction;

  Springs springs(double radius, double overlap) const {
    const double effective = young / (2 * (1 - poisson * poisson));
    const double shear = young / (4 * (1 + poisson) * (2 - poisson));
    const double contact = overlap > 0 ? std::sqrt(radius * overlap) : 0;
    const double force = 4.0 / 3 * effective * contact * overlap;
    return {force, 2 * effective * contact, 8 * shear * contact, 0.4 * force * overlap};
  }
  bool operator==(const HertzMindlin&) const = default;
};

using ContactLaw = std::variant<LinearSprings, ConstantSprings, HertzMindlin>;

inline const Friction& friction_of(const ContactLaw& law) {
  return std::visit([](const auto& chosen) -> const Friction& { return chosen.friction; }, law);
}

/// Brittle cement between grains that touch at the start. A bond also pulls; it breaks for good when its tension
/// exceeds tensile_strength times the area pi min(r)^2, or its shear force shear_strength times that area plus the
/// friction of a pressed contact.
struct Cohesion {
  double tensile_strength; // Pa
  double shear_strength;   // Pa

  bool operator==(const Cohesion&) const = default;
};

} // namespace pfv
