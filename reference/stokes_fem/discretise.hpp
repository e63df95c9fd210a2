#pragma once

#include "pfv/problem/case.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

namespace reference::stokes_fem {

/// Mesh, curved mapping and numbered unknowns; what it is made of is deal.II's and stays in discretisation.hpp.
struct Discretisation;

/// Reads a tetrahedral MSH 2.2 file whose surface groups are named as meshing::void_mesh names them, scales it as the
/// case
/// (`unit`: box from the origin, longest side one, as in unit_case) and bends its boundary edges onto the exact
/// surfaces. `origin` and `length` (m) are where the unit box begins in the file and how long its unit is. In a
/// periodic box the packing is that of meshing::with_images, and opposite nodes are one. Throws
/// pfv::SolveError when the file is not such a mesh.
std::shared_ptr<Discretisation> discretise(const std::filesystem::path& mesh, const pfv::Case& unit,
                                           const pfv::Vec3& origin, double length, double bridge_radius);

struct MeshFacts {
  std::size_t cells = 0;
  std::size_t curved_cells = 0;
  std::size_t straightened_cells = 0;
  std::size_t velocity_nodes = 0;
  std::size_t pressure_nodes = 0;
};

MeshFacts facts(const Discretisation& discretisation);

/// Name and version of the library the elements come from.
std::string element_library();

} // namespace reference::stokes_fem
