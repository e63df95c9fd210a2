#pragma once

#include "meshing/mesh_quality.hpp"
#include "pfv/problem/packing.hpp"

#include <array>
#include <vector>

namespace meshing {

/// Straight tetrahedra and the triangles that lie on spheres, by node.
struct LinearMesh {
  std::vector<pfv::Vec3> nodes; // m
  std::vector<std::array<int, 4>> tetrahedra;
  std::vector<std::array<int, 3>> sphere_triangles;
};

/// Three times inradius over circumradius: 1 for the regular tetrahedron, 0 for a flat one, negative for an inverted
/// one.
double tetrahedron_quality(const std::array<pfv::Vec3, 4>& corners);

/// Sizes, shapes, and volume and surface against the exact ones of the packing. The counts of bridges and parts are not
/// in a mesh and left at zero.
MeshQuality measure_mesh(const LinearMesh& mesh, const pfv::Packing& packing);

} // namespace meshing
