#pragma once

#include "reference/openfoam/case_files.hpp"
#include "reference/openfoam/flow_fields.hpp"

namespace reference::openfoam {

struct Traction {
  pfv::Vec3 force = pfv::Vec3::Zero(); // N
  pfv::Vec3 shear = pfv::Vec3::Zero(); // N, the part - mu du/dn of it
  double area = 0;                     // m^2
  double mean_pressure = 0;            // Pa
};

/// Force p n - mu du/dn of the fluid on a no-slip patch, n out of the fluid. As in the discrete momentum balance, a
/// face has the pressure of its cell, and the velocity falls to zero over the cell's distance.
Traction on_wall(const FoamMesh& mesh, const MeshPatch& patch, const FlowFields& fields, const Units& units);

/// Force (p - 2 mu du_n/dn) n of the fluid on a slip wall, in N.
pfv::Vec3 on_slip_wall(const FoamMesh& mesh, const MeshPatch& patch, const FlowFields& fields, const Units& units);

} // namespace reference::openfoam
