#pragma once

#include "pfv/problem/case.hpp"
#include "reference/method.hpp"

namespace reference::stokes_fem {

/// Unknowns from the integral of 1/h^3 over the void, h the element length the mesher is asked for; CPU seconds (mesh
/// included) and memory from the unknowns.
Estimate estimate_cost(const pfv::Case& problem, double mesh_size);

} // namespace reference::stokes_fem
