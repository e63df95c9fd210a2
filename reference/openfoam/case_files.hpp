#pragma once

#include "pfv/problem/case.hpp"
#include "reference/openfoam/foam_mesh.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace reference::openfoam {

/// Units in which a case is solved, so that neither its size nor its viscosity matters to the solver: lengths in box
/// sides and pressures from 0 to 1 with a kinematic viscosity of `viscosity`. As velocities are below 1 / viscosity,
/// the Reynolds number is below 1 / viscosity^2 and the convective term that simpleFoam always has is round-off.
struct Units {
  static constexpr double viscosity = 1000;
  double length;         // m, largest side of the box
  double pressure;       // Pa, largest minus smallest face pressure
  double lower_pressure; // Pa, the smallest face pressure
  double fluid;          // Pa s

  double flux() const { return viscosity * pressure / fluid * length * length * length; } // m^3/s
  double force() const { return pressure * length * length; }                             // N
};

/// The units of a case; the pressure unit is zero when no two faces have different pressures.
Units units_of(const pfv::Case& problem);

/// The packing in these units.
pfv::Packing in_units(const pfv::Packing& packing, const Units& units);

/// A dictionary or field: OpenFOAM's header of this class and the text. Throws pfv::SolveError when it cannot be
/// written.
void write_foam_file(const std::filesystem::path& file, std::string_view kind, std::string_view text);

/// What simpleFoam is told that suits one kind of mesh better than another.
struct SolverSettings {
  std::string gradient; // scheme
  double relaxation;    // of the momentum equation
  /// Of the residuals: the permeability is within 1e-6 of the one where they vanish.
  double tolerance = 1e-6;
};

/// system/ and constant/: schemes, solvers and the fluxes through `open_faces` recorded on the way.
void write_dictionaries(const std::filesystem::path& folder, const std::vector<std::string>& open_faces,
                        const SolverSettings& settings);

/// system/decomposeParDict: slices of the same thickness across the longest side of the box.
void write_decomposition(const std::filesystem::path& folder, const pfv::Box& box, int ranks);

/// 0/p and 0/U: pressure faces, slip walls, no slip on spheres and bridges.
void write_fields(const std::filesystem::path& folder, const FoamMesh& mesh, const pfv::Case& problem);

} // namespace reference::openfoam
