#pragma once

#include <cstddef>
#include <string>

namespace meshing {

/// How well a mesh stands for the exact geometry, and how well it is shaped.
struct MeshQuality {
  std::size_t nodes = 0;
  std::size_t tetrahedra = 0;
  double volume = 0;              // m^3, of the straight tetrahedra
  double exact_volume = 0;        // m^3, box minus union of spheres (bridges not counted)
  double volume_error = 0;        // volume / exact_volume - 1
  double surface = 0;             // m^2, of the straight triangles on spheres
  double exact_surface = 0;       // m^2, sphere surfaces inside the box
  double surface_error = 0;       // surface / exact_surface - 1
  std::size_t bridges = 0;        // that bound fluid
  std::size_t parts = 0;          // of the fluid, not connected to each other
  std::size_t enclosed_parts = 0; // left out of the mesh, as they touch no face of the box
  double worst_quality = 0;       // smallest 3 inradius / circumradius over tetrahedra, 1 is regular

  bool operator==(const MeshQuality&) const = default;
};

/// Throws std::runtime_error on text that is not what the other one wrote.
std::string to_json(const MeshQuality& quality);
MeshQuality mesh_quality_from_json(const std::string& text);

} // namespace meshing
