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
  std::array<std::vector<int>, 3> holder; // by component and node: index into labels, or free
  std::array<Eigen::VectorXd, 6>
      face_weight; // by pfv::Face: integral of phi_i over a pressure or periodic face, else empty
};

/// Grains hold all three components, slip walls the normal one, pressure faces the two tangential ones unless these are
/// free. Where pieces meet a grain comes first, then a slip wall. Throws pfv::SolveError when a face with a pressure
/// has no surface in the mesh.
Boundary make_boundary(const Discretisation& discretisation, const pfv::FaceConditions& faces);

} // namespace reference::stokes_fem
