#pragma once

#include "meshing/mesh_quality.hpp"
#include "pfv/problem/packing.hpp"

#include <string>

namespace mesher {

/// Part of what meshes are cached by: raised whenever the same packing and settings give another mesh.
inline constexpr int version = 3;

/// Meshes the void of a packing with linear tetrahedra and writes it as ASCII MSH 2.2.
/// Throws std::runtime_error and gmsh's own exceptions (std::string, int).
meshing::MeshQuality generate_mesh(const pfv::Packing& packing, double mesh_size, double bridge_radius,
                                   const std::string& file);

} // namespace mesher
