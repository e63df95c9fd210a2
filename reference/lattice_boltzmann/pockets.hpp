#pragma once

#include "reference/lattice_boltzmann/voxels.hpp"

namespace reference::lattice_boltzmann {

/// Gives the fluid voxels through which no flow can pass, as they are not connected to a way from one end of the box to
/// the other along the axis of the flow, to the nearest sphere: what is bounced back on all sides would swing for
/// ever. Returns their number. Throws pfv::SolveError when there is no way at all.
std::size_t fill_pockets(const FlowQuestion& question, Voxels& voxels);

} // namespace reference::lattice_boltzmann
