#include "pfv/problem/error.hpp"
#include "pfv/problem/packing_file/vtk/read_vtk_points.hpp"

namespace pfv {

VtkPoints read_vtk_points(const std::string& file, const std::string&) {
  throw InputError(file + ": a VTK file, and this build has no VTK (Debian package libvtk9-dev)");
}

} // namespace pfv
