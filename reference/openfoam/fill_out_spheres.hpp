#pragma once

#include "pfv/problem/packing.hpp"
#include "reference/openfoam/foam_mesh.hpp"

#include <cstddef>

namespace reference::openfoam {

/// Puts the points of spheres' faces on the spheres, then moves them outward until the faces between them lie as much
/// outside as inside the sphere: with its corners on the sphere a triangle of side h lies h^2 / 8r inside on average,
/// and 1 % of the radius is 10 % of the permeability of a dense packing. Points on a face of the box stay on it, points
/// on two patches that are not faces (rims of bridges) stay where they are, and so does every point whose move would
/// turn a cell inside out. The packing is in the units of the mesh. Returns how many points moved.
std::size_t fill_out_spheres(FoamMesh& mesh, const pfv::Packing& packing);

} // namespace reference::openfoam
