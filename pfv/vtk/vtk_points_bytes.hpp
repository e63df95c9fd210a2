#pragma once

#include "pfv/vtk/read_vtk_points.hpp"

namespace pfv {

// Points as bytes, from one process to another on the same machine: from_bytes(to_bytes(points)) is points.
std::string to_bytes(const VtkPoints& points);
VtkPoints from_bytes(std::string_view bytes);

} // namespace pfv
