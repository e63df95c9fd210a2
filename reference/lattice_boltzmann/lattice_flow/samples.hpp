#pragma once

#include "reference/lattice_boltzmann/lattice_flow/flow_lattice.hpp"

namespace reference::lattice_boltzmann {

/// Pressures without the driving gradient at the question's points, linear between the centres of the fluid voxels
/// around; NaN in spheres.
std::vector<double> pressures_at_points(const FlowQuestion& question, const Voxels& voxels, const Fields& fields);

/// Integral of u.n over the question's facets, midpoints of triangles of at most half a voxel, u linear between the
/// centres of voxels and zero in spheres. NaN for a facet of less than three corners.
std::vector<double> fluxes_through_facets(const FlowQuestion& question, const Voxels& voxels, const Fields& fields);

} // namespace reference::lattice_boltzmann
