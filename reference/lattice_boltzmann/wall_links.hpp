#pragma once

#include "reference/lattice_boltzmann/voxels.hpp"

namespace reference::lattice_boltzmann {

/// A step from a fluid voxel that ends in a solid one, of the box or beyond its faces.
struct WallLink {
  std::array<int, 3> voxel; // the fluid one
  std::int32_t direction;
  std::int32_t sphere;
  bool narrow;     // the voxel behind is solid too
  double fraction; // of the step from the voxel's centre to the nearest sphere surface
};

std::vector<WallLink> wall_links(const FlowQuestion& question, const Voxels& voxels);

/// What the sphere inside the box gets from momentum handed over along a link: a link whose surface lies beyond a
/// mirror acts on the image, so its image acts on the sphere, and beyond a pressure face with all signs changed.
std::array<double, 3> on_sphere_inside(const FlowQuestion& question, const WallLink& link,
                                       std::array<double, 3> momentum);

} // namespace reference::lattice_boltzmann
