#pragma once

#include "reference/method.hpp"

namespace reference {

/// Steady creeping flow by OpenFOAM's stock simpleFoam on a gmsh mesh of linear tetrahedra.
std::unique_ptr<Method> make_openfoam();

} // namespace reference
