#pragma once

#include "reference/stokes_fem/boundary.hpp"
#include "reference/stokes_fem/stokes_system.hpp"

#include <vector>

namespace reference::stokes_fem {

/// The equations of one velocity component without its fixed unknowns.
struct VelocityComponent {
  std::vector<int> free_index; // by node, -1 when fixed
  Eigen::Index size = 0;       // free unknowns
  SparseRows divergence;
  Eigen::VectorXd load; // of the pressure faces and the mean gradient

  Eigen::VectorXd gather(const Eigen::VectorXd& nodal) const;
  Eigen::VectorXd scatter(const Eigen::VectorXd& values) const; // zero on fixed nodes
};

using VelocityComponents = std::array<VelocityComponent, 3>;

/// Where no face has a pressure, one pressure unknown is held at zero by leaving its equation out.
VelocityComponents free_components(const StokesSystem& system, const Boundary& boundary,
                                   const pfv::FaceConditions& faces);

} // namespace reference::stokes_fem
