#pragma once

#include "pfv/simulation/simulation.hpp"

namespace pfv {

/// A loose box of grains (unit cube, solid fraction 0.5, density 2600) under a piston as heavy as they are, at 1 kPa,
/// in a fluid of this viscosity (Pa s) that drains through both ends: the scene that time steps are tried on.
Scene drained_box(int grains, double radius_ratio, double viscosity);

} // namespace pfv
