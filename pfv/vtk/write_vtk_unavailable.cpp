#include "pfv/problem/error.hpp"
#include "pfv/vtk/write_vtk.hpp"

namespace pfv {

void write_vtk(const std::filesystem::path&, const Packing&, const SteadyFlow&) {
  throw InputError("--vtk: this build has no VTK (Debian package libvtk9-dev)");
}

} // namespace pfv
