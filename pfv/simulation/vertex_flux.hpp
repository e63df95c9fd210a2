#pragma once

#include "pfv/simulation/solid_flux.hpp"

namespace pfv {

/// The rates of volume of Catalano et al. 2011, eq. (4): a pore is the tetrahedron of its four vertices, whose volume
/// changes by the motion of these. To compare with SolidFlux only: paired with the forces of eq. (9), which are those
/// of SolidFlux, it is not adjoint to them, and grains of different sizes can draw energy from the fluid. Throws
/// InputError for a network with walls, whose pores are no tetrahedra.
SolidFlux vertex_flux(const PoreNetwork& network);

} // namespace pfv
