#pragma once

#include "reference/answer.hpp"
#include "reference/probes.hpp"
#include "reference/stokes_fem/flow_mesh.hpp"
#include "reference/stokes_fem/unit_case.hpp"

namespace reference::stokes_fem {

/// Fills the answer's point_pressures (NaN inside spheres and bridges) and facet_fluxes, in SI units, of a flow in
/// those of `unit`. Places outside a periodic box are taken to their image in it, with the pressure's rise from box to
/// box.
void sample(const FlowMesh& flow, const UnitCase& unit, const Probes& probes, Answer& answer);

} // namespace reference::stokes_fem
