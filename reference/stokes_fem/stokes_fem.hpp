#pragma once

#include "reference/method.hpp"

namespace reference {

/// Stokes flow by finite elements: Taylor-Hood P2/P1 on curved tetrahedra (deal.II) of meshing::void_mesh.
std::unique_ptr<Method> make_stokes_fem();

} // namespace reference
