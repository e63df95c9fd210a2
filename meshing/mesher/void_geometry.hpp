#pragma once

#include "meshing/contact_bridges.hpp"
#include "meshing/periodic_images.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace mesher {

/// Tags of gmsh entities that bound the fluid.
struct VoidGeometry {
  std::vector<int> volumes;
  std::map<std::string, std::vector<int>> surfaces; // by name: x_min ... z_max, sphere_K, bridge_...
  std::size_t enclosed = 0;                         // volumes left out, as they touch no face of the box
};

/// Builds box minus spheres minus bridges in a new gmsh model with OpenCASCADE and names every surface by the sphere,
/// cylinder or plane it lies on. Each `attempt` turns the spheres another way. Periodic faces get
/// the same mesh. Throws std::runtime_error when a boolean
/// fails, its volume is wrong, or a surface lies on none or on two, and gmsh's own exceptions (std::string, int).
VoidGeometry build_void(const meshing::ImagedPacking& imaged, const std::vector<meshing::Bridge>& bridges,
                        std::uint64_t attempt);

} // namespace mesher
