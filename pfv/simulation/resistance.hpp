#pragma once

#include "pfv/simulation/solid_flux.hpp"

#include <Eigen/Core>

namespace pfv {

struct FlowSystem;

/// What the fluid does against the motion of the spheres, C = B A^-1 B^T (kg/s), by sphere and direction, all of it
/// filled in: for small packings. Column m is minus the forces of the pressures that a unit velocity of sphere m/3
/// along axis m%3 raises; `rates` says what volumes change, `forces` who is pushed: the same, unless two rules are
/// compared.
Eigen::MatrixXd resistance(const FlowSystem& system, const SolidFlux& rates, const SolidFlux& forces);

/// How far a matrix is from one that only takes energy.
struct Passivity {
  double least;     // smallest eigenvalue of the symmetric part over the largest
  double asymmetry; // |C - C^T| over |C|, Frobenius
};
Passivity passivity(const Eigen::MatrixXd& resistance);

} // namespace pfv
