#pragma once

#include "meshing/mesh_quality.hpp"
#include "pfv/problem/packing.hpp"

#include <string>

namespace mesher {

/// Part of what meshes are cached by: raised whenever the same packing and settings give another mesh.
inline constexpr int version = 5;

/// Meshes the void of a packing with linear tetrahedra and writes it as ASCII MSH 2.2, when geometry or mesh turn out
/// wrong from another geometry, a few times. Throws std::runtime_error with the last reason when that does not help.
meshing::MeshQuality generate_mesh(const pfv::Packing& packing, const pfv::PeriodicAxes& periodic, double mesh_size,
                                   double bridge_radius, const std::string& file);

} // namespace mesher
