#pragma once

#include "meshing/linear_mesh.hpp"
#include "meshing/mesh_quality.hpp"
#include "pfv/problem/packing.hpp"

#include <array>

namespace meshing {

/// Three times inradius over circumradius: 1 for the regular tetrahedron, 0 for a flat one, negative for an inverted
/// one.
double tetrahedron_quality(const std::array<pfv::Vec3, 4>& corners);

/// Sizes, shapes, and volume and surface against the exact ones of the packing. The counts of parts are not
/// in a mesh and left at zero.
MeshQuality measure_mesh(const LinearMesh& mesh, const pfv::Packing& packing);

} // namespace meshing
