#pragma once

#include "pfv/problem/packing_file/vtk/read_vtk_points.hpp"

namespace pfv {

// Points as bytes, from one process to another on the same machine: vtk_points_in(bytes_of(points)) is points.
std::string bytes_of(const VtkPoints& points);
VtkPoints vtk_points_in(std::string_view bytes);

} // namespace pfv
