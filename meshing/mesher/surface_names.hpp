#pragma once

#include "meshing/contact_bridges.hpp"
#include "pfv/problem/packing.hpp"

#include <string>
#include <vector>

namespace mesher {

/// The one sphere, bridge or box face that all points lie on. The points may be anywhere on the untrimmed surface.
/// Throws std::runtime_error when there is none or more than one.
std::string name_of_surface(const std::vector<pfv::Vec3>& points, const pfv::Packing& packing,
                            const std::vector<meshing::Bridge>& bridges);

} // namespace mesher
