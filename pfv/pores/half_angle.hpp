#pragma once

#include "pfv/pores/lanes.hpp"

namespace pfv {

/// Half the solid angle at the corner of a pyramid (Van Oosterom & Strackee 1983, eq. (8)) from the directions to the
/// other corners u, v, to the apex w, the lengths of u and v, and det(u, v, w).
PFV_INLINE double half_angle(const lanes::Vector& u, const lanes::Vector& v, const lanes::Vector& w, double nu,
                             double nv, double det) {
  const double nw = norm(w);
  return lanes::atan2(det, nu * nv * nw + dot(u, v) * nw + dot(u, w) * nv + dot(v, w) * nu);
}

} // namespace pfv
