#pragma once

#include "pfv/flow/steady_flow.hpp"

#include <filesystem>

namespace pfv {

/// Writes two files that ParaView opens into a folder, which is made if need be (SI units):
///   pores.vtu    a point per pore at its power centre: pressure, volume, void_volume; a line per
///                throat: conductance, flux; where a throat leaves a periodic box it ends at an image of its pore,
///                a point of its own
///   spheres.vtp  a point per sphere: radius, pressure_force, viscous_force, and buoyancy when the case names it; the
///                field array box, with which it reads back as a packing
/// Throws InputError when the folder cannot be written or this build has no VTK.
void write_vtk(const std::filesystem::path& folder, const Packing& packing, const SteadyFlow& flow);

} // namespace pfv
