#pragma once

#include "pfv/flow/fluid_forces.hpp"
#include "pfv/flow/wall_rules.hpp"
#include "pfv/pores/pore_network.hpp"
#include "pfv/problem/face_condition.hpp"

#include <array>
#include <vector>

namespace pfv {

/// Evens out viscous forces between spheres that share throats:
///
///   F_a += share sum_throats sum_b w_ab (F_b / gamma_b - F_a / gamma_a),  w_ab = (gamma_a + gamma_b - gamma_c) / 2,
///
/// gamma_a what sphere a wets, within w in the throat, whose corners are a, b, c, and within the mean shear F_a /
/// gamma_a in all. These w are the only ones that are the same both ways and give each corner what it wets in the
/// throat: no force is lost, the diagonals of a square throat count nothing however it is cut, and where spheres change
/// partners throats of no length have no say.
///
/// The fluid between two spheres shears both, and each all around, as in Stokes' own solution, where the traction is
/// one and the same everywhere on the sphere; a throat by itself shears its own three where they bound it.
class ShearSpread {
public:
  /// A face stands for what it mirrors: behind a slip wall the flow goes on the other way around along the normal,
  /// behind an imposed pressure along the face. A wall that holds the fluid back takes no part.
  ShearSpread(double share, const FaceConditions& faces, const WallRule& walls);

  /// Nothing is allocated when there are as many spheres as before.
  void operator()(const PoreNetwork& network, FluidForces& forces);

private:
  /// What there is of the mean shear (Pa) behind a wall, at a sphere in front of it.
  Vec3 behind(Face wall, const Vec3& shear) const;

  double share_;
  std::array<Vec3, 6> mirror_; // by index(Face), factors of the components of shear
  std::vector<double> wetted_; // m^2 by sphere
  std::vector<Vec3> shear_;    // Pa by sphere, the mean
};

} // namespace pfv
