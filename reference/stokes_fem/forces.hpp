#pragma once

#include "reference/stokes_fem/boundary.hpp"
#include "reference/stokes_fem/stokes_system.hpp"

namespace reference::stokes_fem {

struct Forces {
  std::vector<pfv::Vec3> sphere;
  std::array<pfv::Vec3, 6> wall;
};

/// Force of the fluid on every sphere and box face, of unit viscosity, by the nodal residual of the momentum equation
/// (variational: as exact as the solution, and the sum over spheres and faces is zero to the solver's tolerance). The
/// force on a bridge is shared equally by its two spheres, or goes to the one sphere that touches a wall. `faces` gives
/// the pressures `flow` was driven by.
Forces fluid_forces(const Discretisation& discretisation, const StokesSystem& system, const Boundary& boundary,
                    const pfv::FaceConditions& faces, const FlowField& flow, std::size_t spheres);

} // namespace reference::stokes_fem
