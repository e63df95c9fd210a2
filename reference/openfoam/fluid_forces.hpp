#pragma once

#include "meshing/contact_bridges.hpp"
#include "reference/openfoam/case_files.hpp"
#include "reference/openfoam/flow_fields.hpp"

#include <array>
#include <vector>

namespace reference::openfoam {

struct FluidForces {
  std::vector<pfv::Vec3> on_spheres; // N
  std::vector<pfv::Vec3> viscous;    // N, the part of the shear in it
  std::array<pfv::Vec3, 6> on_faces; // N, by pfv::Face
};

/// Forces of the fluid in SI units: traction p n - mu du/dn on every triangle of a patch, n out of the fluid.
/// What the mesh leaves out is put back, so that no force depends on where pressure zero is:
/// - a bridge's traction is shared equally by its two spheres, and its mean pressure acts on the cap it hides of each;
/// - a pressure face acts on the discs that spheres cut out of it, each sphere's in proportion to its exact area, and
/// so
///   carries its pressure over its whole area.
/// A sphere centred on a slip wall is half of a mirrored pair: its force normal to the wall is the wall's.
FluidForces fluid_forces(const FoamMesh& mesh, const FlowFields& fields, const pfv::Case& problem,
                         const std::vector<meshing::Bridge>& bridges);

} // namespace reference::openfoam
