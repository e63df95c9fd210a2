#include "meshing/contact_bridges.hpp"
#include "meshing/exact_void.hpp"
#include "pfv/problem/error.hpp"
#include "reference/on_path.hpp"
#include "reference/openfoam/bridge_radius.hpp"
#include "reference/openfoam/case_files.hpp"
#include "reference/openfoam/mesh_route.hpp"
#include "reference/openfoam/programs.hpp"
#include "reference/openfoam/snappy_files.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace reference::openfoam {

namespace {

// Side of the cells at mesh_size 1, in units of the void's volume over its surface.
constexpr double cell_size = 0.2;

double cell_length(const meshing::VoidMeasure& measure, double mesh_size) {
  return mesh_size * cell_size * measure.volume / measure.surface;
}

class SnappyRoute : public MeshRoute {
public:
  std::string method_name() const override { return "openfoam_snappy"; }
  std::string description() const override {
    return "Stokes flow by finite volumes on cubes fitted to the spheres (OpenFOAM's snappyHexMesh and simpleFoam)";
  }
  std::string version() const override { return {}; }
  std::optional<std::string> unavailable() const override {
    for (const char* program : {"blockMesh", "snappyHexMesh"})
      if (!on_path(program))
        return fmt::format("no program {} on PATH (Debian package openfoam)", program);
    return std::nullopt;
  }
  double convergence_order() const override { return 2; }
  double cells(const pfv::Case& problem, double mesh_size) const override {
    const auto measure = meshing::exact_void(problem.packing);
    return measure.volume / std::pow(cell_length(measure, mesh_size), 3);
  }
  /// Point-based gradients give the same to 0.05 %, least squares and pressures extrapolated to the walls to 2 %; none
  /// changes the error of the cells across the throats. 0.9 takes three quarters of the iterations of 0.93.
  SolverSettings solver() const override { return {"Gauss linear", 0.9}; }
  double seconds_per_cell() const override { return 6e-4; }

  Made make(const std::filesystem::path& folder, const pfv::Case& problem, double mesh_size,
            pfv::Clock& clock) const override {
    const pfv::Packing packing = in_units(problem.packing, units_of(problem));
    const auto measure = meshing::exact_void(packing);
    const auto bridges = meshing::contact_bridges(packing, bridge_radius);
    const double cell = cell_length(measure, mesh_size);
    write_block_mesh(folder, packing.box, cell);
    write_snappy(folder, packing, bridges, point_in_void(packing));
    clock.add("mesh", run_program(folder, {"blockMesh"}).cpu_seconds);
    clock.add("mesh", run_program(folder, {"snappyHexMesh", "-overwrite"}).cpu_seconds);
    for (const char* of_the_mesher : {"cellLevel", "pointLevel"})
      std::filesystem::remove(folder / "0" / of_the_mesher);
    return {units_of(problem).length,
            fmt::format("snappyHexMesh, cubes of {:.3g} m", cell * units_of(problem).length),
            {{"bridges", static_cast<double>(bridges.size())}}};
  }
};

} // namespace

std::unique_ptr<MeshRoute> make_snappy_route() {
  return std::make_unique<SnappyRoute>();
}

} // namespace reference::openfoam
