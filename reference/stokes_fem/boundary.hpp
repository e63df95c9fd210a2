#pragma once

#include "reference/stokes_fem/boundary_labels.hpp"
#include "reference/stokes_fem/discretise.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace reference::stokes_fem {

/// Which piece of boundary fixes each velocity unknown (to zero; no other value occurs).
struct Boundary {
  static constexpr int free = -1;

  std::vector<BoundaryLabel> labels;
  std::array<std::vector<int>, 3> holder;     // by component and node: index into labels, or free
  std::array<Eigen::VectorXd, 6> face_weight; // by pfv::Face: integral of phi_i over a pressure face, else empty
};

/// Grains hold all three components, slip walls the normal one, pressure faces the two tangential ones. Where pieces
/// meet a grain comes first, then a slip wall. Throws pfv::SolveError when a face with a pressure has no surface in the
/// mesh.
Boundary make_boundary(const Discretisation& discretisation, const pfv::FaceConditions& faces);

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

} // namespace reference::stokes_fem
