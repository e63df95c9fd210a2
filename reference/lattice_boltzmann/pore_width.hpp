#pragma once

#include "pfv/problem/case.hpp"
#include "reference/lattice_boltzmann/voxel_grid.hpp"

namespace reference::lattice_boltzmann {

/// Rough measures of the void of a packing, in voxels: how wide and how long flow has to spread to come to rest.
struct VoidMeasures {
  double surface; // of the spheres inside the box
  double width;   // mean hydraulic radius: volume of the void over that surface
  double length;  // longest side of the box

  /// The viscosity that takes the fewest steps. The answer does not depend on it: momentum takes about
  /// 6 width^2 / viscosity steps to spread across pores, pressure 8 viscosity (length / width)^2 along the box. On 200
  /// random spheres it takes a tenth of the steps of a viscosity of 1/2.
  double quickest_viscosity() const;
  /// Steps until the flow is at rest with that viscosity.
  double steps_to_rest() const;
};

/// Of spheres that reach out of the box the part of their extent inside is counted.
VoidMeasures void_measures(const pfv::Case& problem, const VoxelGrid& grid);

} // namespace reference::lattice_boltzmann
