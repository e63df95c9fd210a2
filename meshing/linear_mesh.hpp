#pragma once

#include "pfv/problem/vec3.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace meshing {

/// Straight tetrahedra of the fluid and the triangles that bound it, each on a named surface.
struct LinearMesh {
  struct Triangle {
    std::array<int, 3> nodes;
    int surface; // index in `surfaces`
  };

  std::vector<pfv::Vec3> nodes;               // m
  std::vector<std::array<int, 4>> tetrahedra; // positive volume
  std::vector<Triangle> triangles;
  std::vector<std::string> surfaces; // x_min ... z_max, sphere_K, bridge_...
};

/// Throws std::runtime_error unless every tetrahedron has a positive volume and every face of it is either shared with
/// one other or one of the triangles, each of which bounds one tetrahedron: the mesh is whole.
void check(const LinearMesh& mesh);

/// Writes gmsh's MSH 2.2, ASCII: physical volume `fluid`, one physical surface for each name. Every number has the
/// digits that read back to the same double. Throws std::runtime_error when the file cannot be written.
void write_msh(const LinearMesh& mesh, const std::filesystem::path& file);

} // namespace meshing
