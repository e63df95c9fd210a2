#pragma once

#include "pfv/problem/vec3.hpp"

#include <span>
#include <vector>

namespace meshing {

/// For every point of `from` the number of the point of `to` within `tolerance` (m) of it along each axis, or -1.
std::vector<int> matching_points(std::span<const pfv::Vec3> from, std::span<const pfv::Vec3> to, double tolerance);

} // namespace meshing
