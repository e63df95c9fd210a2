#pragma once

#include "meshing/contact_bridges.hpp"
#include "meshing/periodic_images.hpp"
#include "pfv/problem/packing.hpp"

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace mesher {

/// How spheres and bridges are turned, before they are moved into place. As OpenCASCADE makes them, a sphere has its
/// poles on the z axis and its seam on the half meridian through +x; a cylinder stands on the origin along +z with its
/// seam on +x.
struct Turns {
  std::vector<Eigen::Quaterniond> spheres;
  std::vector<Eigen::Quaterniond> bridges;
};

/// Turns that keep seams and poles, which are edges and vertices of the solids though nothing is there to see, away
/// from the circles where spheres meet bridges, box faces and each other, and from each other where they end on one
/// circle: a seam that grazes a circle makes booleans fail and leaves slivers in the mesh. The best of many random
/// turns for each; another `attempt` draws others, the same one always the same. Images are turned like
/// their originals, away from what any of them meets, so that opposite faces are cut alike.
Turns turns_of_seams(const meshing::ImagedPacking& imaged, const std::vector<meshing::Bridge>& bridges,
                     std::uint64_t attempt);

} // namespace mesher
