#pragma once

#include "reference/stokes_fem/boundary.hpp"

namespace reference::stokes_fem {

/// Velocity by component (N nodes each) and pressure (M nodes), of unit viscosity.
struct FlowField {
  std::array<Eigen::VectorXd, 3> velocity;
  Eigen::VectorXd pressure;
};

/// What a nodal residual credits to the wrong piece of boundary: the part of the traction on box face f that is tested
/// with the functions of nodes another piece holds (or nobody, on a pressure face). One vector per label, to be added
/// to the force of the fluid on it; where the other piece is a label, it loses what the face gains. The traction is
/// that of the symmetric stress, which differs from the Laplacian form's by line integrals over the edges between
/// pressure faces and slip walls.
std::vector<pfv::Vec3> force_transfers(const Discretisation& discretisation, const Boundary& boundary,
                                       const pfv::FaceConditions& faces, const FlowField& flow);

/// Mean pressure over each piece of boundary, by label.
std::vector<double> mean_pressures(const Discretisation& discretisation, const FlowField& flow);

} // namespace reference::stokes_fem
