#pragma once

#include "meshing/contact_bridges.hpp"
#include "pfv/problem/packing.hpp"

#include <filesystem>
#include <vector>

namespace reference::openfoam {

/// system/blockMeshDict: the box filled with cells as near to cubes of side `cell` as divide it, one patch for each
/// face. Lengths in the unit of the mesh.
void write_block_mesh(const std::filesystem::path& folder, const pfv::Box& box, double cell);

/// system/snappyHexMeshDict: a searchableSphere for each sphere, a searchableCylinder for each bridge, castellated and
/// snapped, no layers. `inside` is a point of the fluid.
void write_snappy(const std::filesystem::path& folder, const pfv::Packing& packing,
                  const std::vector<meshing::Bridge>& bridges, const pfv::Vec3& inside);

/// The point of a grid in the box that is farthest from all spheres, off every plane that divides the box evenly.
pfv::Vec3 point_in_void(const pfv::Packing& packing);

} // namespace reference::openfoam
