#pragma once

#include "reference/method.hpp"

namespace reference {

/// Steady creeping flow by OpenFOAM's stock simpleFoam on a gmsh mesh of linear tetrahedra.
std::unique_ptr<Method> make_openfoam();

/// `openfoam_snappy`: the same on the cubes of snappyHexMesh, fitted to the spheres.
std::unique_ptr<Method> make_openfoam_snappy();

} // namespace reference
