#pragma once

#include "reference/method.hpp"

namespace reference::yade {

/// Why FlowEngine is not asked this: it answers permeability setups between slip walls, with three spheres or more that
/// do not reach out of the box by more than a hundredth of their radius, and up to 10 000 cells on a pressure face,
/// past which it writes outside an array of its own.
std::optional<std::string> beyond_limits(const pfv::Case& problem);

/// Measured on random packings of 2e2 ... 2e5 spheres; start-up and reading the packing included.
Estimate expected_cost(const pfv::Case& problem);

} // namespace reference::yade
