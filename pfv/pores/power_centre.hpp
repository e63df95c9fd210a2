#pragma once

#include "pfv/pores/vertex.hpp"
#include "pfv/problem/packing.hpp"

#include <array>

namespace pfv {

/// The point of equal power |x - c|^2 - r^2 with respect to four vertices (m); on every wall among them. For a cell so
/// flat that the point is lost to round-off, the one of least distance to the first sphere.
Vec3 power_centre(const Packing& packing, const std::array<Vertex, 4>& vertices);

} // namespace pfv
