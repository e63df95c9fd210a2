#pragma once

#include "meshing/periodic_images.hpp"
#include "reference/stokes_fem/stokes_system.hpp"
#include "reference/stokes_fem/tractions.hpp"

namespace reference::stokes_fem {

struct Forces {
  std::vector<pfv::Vec3> sphere;
  std::vector<pfv::Vec3> viscous; // on the spheres: what the pressure on their surfaces leaves of `sphere`
  std::array<pfv::Vec3, 6> wall;
};

/// Force of the fluid on every sphere and box face, of unit viscosity, by the nodal residual of the momentum equation
/// (variational: as exact as the solution, and the sum over spheres and faces is zero to the solver's tolerance).
///
/// A bridge stands for a contact whose narrow gap is full of fluid, so besides the force on the bridge (shared equally
/// by its two spheres, or given to the one that touches a wall) the two ends get what that fluid would push them apart
/// with: the mean pressure on the bridge, or the pressure of the open face it ends in, over its section. Without it a
/// simple cubic lattice would carry dp (S - section) instead of dp S.
///
/// Under a mean gradient every sphere also bears what the pressure of that gradient does to it, so that the forces add
/// up to minus the gradient times the volume of the box. A sphere that periodic faces cut is counted whole, once.
///
/// `problem` is the unit case with the packing of `imaged`, its pressures those `flow` was driven by.
Forces fluid_forces(const Discretisation& discretisation, const StokesSystem& system, const Boundary& boundary,
                    const pfv::Case& problem, const meshing::ImagedPacking& imaged, const FlowField& flow,
                    double bridge_radius);

} // namespace reference::stokes_fem
