#pragma once

#include "reference/method.hpp"

namespace reference {

/// Stokes flow by the lattice Boltzmann method on cubic voxels, through Palabos in a process of its own: two relaxation
/// times, linear equilibrium, interpolated bounce-back on the spheres, exact mirrors at slip walls and pressure faces.
/// Its stages: "mesh" (voxels, links, lattice) and "solve".
std::unique_ptr<Method> make_lattice_boltzmann();

} // namespace reference
