#pragma once

#include "meshing/mesh_quality.hpp"
#include "pfv/problem/case.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace meshing {

struct MeshSettings {
  double mesh_size = 1.0;      // scales every element length; 1 is the default, 2 twice as coarse
  double bridge_radius = 0.15; // of the cylinders that replace contacts, in units of the smaller sphere radius
  double wall_limit = 3600;    // s, after which the mesher is stopped; not part of the key
};

/// A tetrahedral mesh of the void of a case's packing, in a file.
struct VoidMesh {
  std::filesystem::path file; // gmsh MSH 2.2 ASCII, linear tetrahedra, metres
  MeshQuality quality;
  double cpu_seconds = 0; // what making it took, also when it comes from the cache
  bool from_cache = false;
};

/// Meshes the void between the spheres of a case inside its box with gmsh, in a child process, or takes it from the
/// cache
/// (`cache_folder`, keyed by the digest of packing and settings).
/// Physical groups: volume `fluid`; surfaces `x_min` ... `z_max` (the parts of the box faces that bound fluid),
/// `sphere_K` (K the 0-based index in the packing) and, where two spheres touch or nearly touch, `bridge_I_J` (I < J),
/// where a sphere touches a wall, `bridge_K_x_min` and so on; a surface that bounds no fluid has no group. Element
/// sizes follow the gap: small where two surfaces are near. In a periodic box K and J also count the images of
/// with_images, and opposite faces have the same triangles. Throws pfv::InputError on settings out of range,
/// pfv::SolveError with gmsh's own last words when it fails and with the reason when there is no mesher.
VoidMesh void_mesh(const pfv::Case& problem, const MeshSettings& settings, const std::filesystem::path& cache_folder);

/// Why meshes cannot be made on this machine or build; nothing when they can. The mesher is the program `$PFV_MESHER`,
/// else
/// `../libexec/mesh_void` beside the running program's folder, else where it was built.
std::optional<std::string> mesher_unavailable();

/// "gmsh 4.8.4, mesher 1", part of the key; empty when it is unavailable.
std::string mesher_version();

/// `$PFV_MESH_CACHE`, else `$XDG_CACHE_HOME/pfv/meshes`, else `~/.cache/pfv/meshes`.
std::filesystem::path default_mesh_cache();

} // namespace meshing
