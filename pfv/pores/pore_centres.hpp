#pragma once

#include "pfv/pores/pore_network.hpp"

namespace pfv {

/// Sets the centre of every pore of a network whose sites, vertices and throats are known, and counts the flat ones.
///
/// A flat pore shares the centre of a neighbour across it, so that the throat between them is contracted and that on
/// the other side is the undivided one; between others' centres it would split a throat in two whose hydraulic radii
/// depend on a jitter of the spheres, however small. Throws SolveError when a centre is not finite.
void set_pore_centres(PoreNetwork& network);

} // namespace pfv
