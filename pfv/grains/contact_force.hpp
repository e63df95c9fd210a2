#pragma once

#include "pfv/grains/candidates.hpp"
#include "pfv/grains/contact_law.hpp"
#include "pfv/grains/contacts.hpp"

#include <algorithm>
#include <cmath>

namespace pfv {

/// Two bodies in contact, seen from the first.
struct Meeting {
  Vec3 normal;         // to the second
  double overlap;      // m
  double radius;       // m, r_i r_j / (r_i + r_j)
  double smaller;      // m, the smaller of the radii
  Vec3 sliding;        // m/s, of the second's surface over the first's, normal part included
  double twist;        // rad/s, mean spin of the two about the normal
  double reduced_mass; // kg; not needed without damping
};

/// A contact that only presses.
struct NoBonds {
  static bool holds(Bond) { return false; }
  double most_shear(Bond&, const Meeting&, double pressed, double friction, double, ContactLosses&) const {
    return friction * std::max(0.0, pressed);
  }
};

/// A contact that may be cemented.
struct Cement {
  Cohesion strength;

  static bool holds(Bond bond) { return bond == Bond::cemented; }
  /// The largest shear force (N) after breaking the bond if it is overloaded.
  double most_shear(Bond& bond, const Meeting& at, double pressed, double friction, double shear,
                    ContactLosses& losses) const {
    const double coulomb = friction * std::max(0.0, pressed);
    if (bond != Bond::cemented)
      return coulomb;
    const double area = std::numbers::pi * at.smaller * at.smaller;
    const double most = strength.shear_strength * area + coulomb;
    if (-pressed <= strength.tensile_strength * area && shear <= most)
      return most;
    bond = Bond::touching;
    ++losses.broken_bonds;
    return coulomb;
  }
};

/// Force of the second on the first (N). The shear force of the last step turns with the contact (its direction by the
/// normal, about the normal by the twist), grows by k_t times the tangential sliding, and is cut at Coulomb's limit.
template <class Law, class Bonds>
Vec3 contact_force(const Law& law, const Bonds& bonds, double friction, const Meeting& at, double step, Vec3& shear,
                   Bond& bond, ContactLosses& losses) {
  const Springs springs = law.springs(at.radius, at.overlap);
  const double approach = -at.sliding.dot(at.normal);
  const double damper = 2 * law.friction.damping * std::sqrt(at.reduced_mass * springs.normal) * approach;

  const double before = shear.squaredNorm();
  if (before > 0) {
    shear -= shear.dot(at.normal) * at.normal;
    const double turned = shear.squaredNorm();
    if (turned > 0)
      shear *= std::sqrt(before / turned);
    shear += step * at.twist * at.normal.cross(shear);
  }
  shear += step * springs.tangential * (at.sliding + approach * at.normal);

  double pressed = springs.force + damper;
  const double size = shear.norm();
  const double most = bonds.most_shear(bond, at, pressed, friction, size, losses);
  if (!Bonds::holds(bond))
    pressed = std::max(0.0, pressed); // it may just have broken
  if (size > most) {
    losses.friction += most * (size - most) / springs.tangential;
    shear *= most / size;
  }
  losses.damping += (pressed - springs.force) * approach * step;
  return shear - pressed * at.normal;
}

} // namespace pfv
