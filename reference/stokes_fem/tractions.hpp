#pragma once

#include "reference/stokes_fem/boundary.hpp"

namespace reference::stokes_fem {

/// Velocity by component (N nodes each) and pressure (M nodes), of unit viscosity. In a periodic box the pressure is
/// what is left of it without its mean gradient.
struct FlowField {
  std::array<Eigen::VectorXd, 3> velocity;
  Eigen::VectorXd pressure;
};

/// What a nodal residual credits to the wrong piece of boundary: the part of the traction on box face f that is tested
/// with the functions of nodes another piece holds (or nobody, on a pressure face). One vector per label, to be added
/// to the force of the fluid on it; where the other piece is a label, it loses what the face gains. The traction is
/// that of the symmetric stress, which differs from the Laplacian form's by line integrals over the edges between
/// pressure faces and other faces. `problem` is the unit case.
std::vector<pfv::Vec3> force_transfers(const Discretisation& discretisation, const Boundary& boundary,
                                       const pfv::Case& problem, const FlowField& flow);

/// Integrals over a piece of boundary, normals out of the fluid.
struct SurfacePressure {
  double area = 0;
  double integral = 0;                        // of the pressure, the mean gradient's part included
  pfv::Vec3 area_vector = pfv::Vec3::Zero();  // of the normal
  pfv::Vec3 push_of_rise = pfv::Vec3::Zero(); // of the normal times the mean gradient's part alone
  pfv::Vec3 push_of_flow = pfv::Vec3::Zero(); // of the normal times the rest of the pressure
};

/// By label. `gradient` is the mean one of a periodic box, its part of the pressure zero at `middle`.
std::vector<SurfacePressure> surface_pressures(const Discretisation& discretisation, const FlowField& flow,
                                               const pfv::Vec3& gradient, const pfv::Vec3& middle);

} // namespace reference::stokes_fem
