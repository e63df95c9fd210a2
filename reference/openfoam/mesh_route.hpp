#pragma once

#include "pfv/clock.hpp"
#include "pfv/problem/case.hpp"
#include "reference/openfoam/case_files.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace reference::openfoam {

/// How an OpenFOAM method comes by its mesh. All else is shared by the methods.
class MeshRoute {
public:
  virtual ~MeshRoute() = default;

  virtual std::string method_name() const = 0;
  virtual std::string description() const = 0;
  /// Of the mesher, when it is not a part of OpenFOAM; else empty.
  virtual std::string version() const = 0;
  /// Why this route is closed on this machine or build; nothing when it is open.
  virtual std::optional<std::string> unavailable() const = 0;
  /// Of the convergence of the permeability in mesh_size.
  virtual double convergence_order() const = 0;
  /// Expected number of cells.
  virtual double cells(const pfv::Case& problem, double mesh_size) const = 0;
  virtual SolverSettings solver() const = 0;
  /// Expected CPU seconds of the solver for a cell.
  virtual double seconds_per_cell() const = 0;

  struct Made {
    double unit;                          // m, of the mesh's coordinates
    std::string note;                     // what kind of mesh it is
    std::map<std::string, double> counts; // for the answer
  };
  /// Writes constant/polyMesh of a case folder whose system/ is there, with a patch for each face of the box, each
  /// sphere and each bridge, as patch_named reads them. Throws pfv::SolveError when there is no mesh.
  virtual Made make(const std::filesystem::path& folder, const pfv::Case& problem, double mesh_size,
                    pfv::Clock& clock) const = 0;
};

/// The dual of tetrahedra by gmsh, small in the gaps; shared with the finite elements' mesher and its cache.
std::unique_ptr<MeshRoute> make_gmsh_route();

/// Cubes cut by the spheres and moved onto them, by OpenFOAM's own blockMesh and snappyHexMesh.
std::unique_ptr<MeshRoute> make_snappy_route();

} // namespace reference::openfoam
