#pragma once

#include "reference/openfoam/flow_fields.hpp"
#include "reference/probes.hpp"

#include <vector>

namespace reference::openfoam {

struct Samples {
  std::vector<double> point_pressures; // Pa, NaN in the solid and outside the box
  std::vector<double> facet_fluxes;    // m^3/s along the normals, NaN of a facet that lies in the solid altogether
};

/// Pressures at points and the integrals of u.n over facets, from velocities linear in each cell and pressures fitted
/// around each point. A facet is cut into 32^2
/// triangles for each of its own, each counted by its middle; spheres carry no flow. Positions and results in SI units,
/// fields as simpleFoam wrote them.
Samples sample(const FoamMesh& mesh, const FlowFields& fields, const pfv::Case& problem, const Probes& probes);

} // namespace reference::openfoam
