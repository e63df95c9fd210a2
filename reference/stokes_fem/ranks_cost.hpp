#pragma once

#include "reference/method.hpp"

namespace reference::stokes_fem {

/// Of stokes_fem on several ranks, the mesh included, all ranks together; `mesh_size` as in meshing::MeshSettings.
Estimate estimate_cost_on_ranks(const pfv::Case& problem, double mesh_size, int ranks);

} // namespace reference::stokes_fem
