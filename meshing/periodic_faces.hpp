#pragma once

#include "meshing/linear_mesh.hpp"
#include "pfv/problem/packing.hpp"

namespace meshing {

/// Moves the nodes on the upper of each pair of periodic faces to exactly above those on the lower one, from which they
/// are `tolerance` (m) away at most. Throws std::runtime_error when a triangle on one of the two faces has none
/// opposite.
void align_periodic_faces(LinearMesh& mesh, const pfv::Box& box, const pfv::PeriodicAxes& periodic, double tolerance);

} // namespace meshing
