#pragma once

#include "pfv/problem/packing.hpp"

#include <string>
#include <vector>

namespace meshing {

/// A solid cylinder in place of a contact, where the fluid gap is too thin to be meshed and carries no flow to speak
/// of. Its ends lie inside a sphere or outside the box.
struct Bridge {
  std::string name; // bridge_I_J, or bridge_K_x_min and so on
  pfv::Vec3 from;   // m, on the axis
  pfv::Vec3 to;     // m
  double radius;    // m
};

/// Gap under which two spheres are bridged, in units of the smaller radius. The rim of a bridge of radius 0.15 between
/// touching spheres is 0.02 high: a smaller gap would ask for elements smaller than those all along that rim.
inline constexpr double bridged_gap = 0.02;

/// The bridges of a packing, `bridge_radius` in units of the smaller sphere radius. Against 0.1 a radius of 0.15 lowers
/// the permeability of touching lattices by 0.005 (simple cubic) to 0.03 % (fcc), 0.2 by 0.01 to 0.27 %, 0.25 by 0.06
/// to 1.2 % (bridge_sensitivity.csv); 0.1 leaves worse elements at the rim. A wall counts as the mirror that a slip
/// wall is, so a sphere is bridged to it at half the gap. Spheres that overlap so much that they meet in a circle wider
/// than the bridge need none. Pairs first, then walls, each in the order of the packing. Periodic faces are no walls;
/// images are spheres like others, their contacts outside the box left out.
std::vector<Bridge> contact_bridges(const pfv::Packing& packing, double bridge_radius,
                                    const pfv::PeriodicAxes& periodic = {});

} // namespace meshing
