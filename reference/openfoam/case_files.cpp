#include "reference/openfoam/case_files.hpp"

#include "pfv/problem/error.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <string_view>

namespace reference::openfoam {

namespace {

// Double braces: these are fmt strings.
constexpr std::string_view control = R"(
application simpleFoam;
startFrom startTime; startTime 0; stopAt endTime; endTime {iterations}; deltaT 1;
writeControl timeStep; writeInterval {iterations};
writeFormat ascii; writePrecision 16; timeFormat general; runTimeModifiable false;
functions {{ {functions} }}
)";

constexpr std::string_view flux_history = R"(
  {name} {{
    type surfaceFieldValue; libs (fieldFunctionObjects); log false; writeFields false;
    fields (phi); operation sum; regionType patch; name {name};
    writeControl timeStep; writeInterval 10;
  }})";

constexpr std::string_view schemes = R"(
ddtSchemes {{ default steadyState; }}
gradSchemes {{ default {gradient}; }}
divSchemes {{
  default none;
  div(phi,U) bounded Gauss linear;
  div((nuEff*dev2(T(grad(U))))) Gauss linear;
}}
laplacianSchemes {{ default Gauss linear corrected; }}
interpolationSchemes {{ default linear; flux(HbyA) skewCorrected linear; }}
snGradSchemes {{ default corrected; }}
)";

constexpr std::string_view solution = R"(
solvers {{
  p {{ solver GAMG; smoother GaussSeidel; nCellsInCoarsestLevel 50; tolerance 1e-12; relTol 0.1; }}
  U {{ solver smoothSolver; smoother symGaussSeidel; tolerance 1e-12; relTol 0.1; }}
}}
SIMPLE {{ consistent yes; nNonOrthogonalCorrectors 0; residualControl {{ p {tolerance}; U {tolerance}; }} }}
relaxationFactors {{ fields {{ p 1; }} equations {{ U {relaxation}; }} }}
)";

constexpr int iteration_limit = 5000;

struct Boundary {
  std::string pressure;
  std::string velocity;
};

Boundary boundary(const Patch& part, const pfv::FaceConditions& faces, const Units& units) {
  const auto* face = std::get_if<pfv::Face>(&part);
  if (!face)
    return {"type zeroGradient;", "type noSlip;"};
  const auto* open = std::get_if<pfv::Pressure>(&faces[static_cast<std::size_t>(pfv::index(*face))]);
  if (!open)
    return {"type zeroGradient;", "type slip;"};
  // pressureInletVelocity takes the normal velocity from the flux, for outflow as well, and no tangential one; with
  // zeroGradient the viscous traction is zero and the pressure all of it.
  const std::string velocity = open->tangential == pfv::Tangential::free
                                   ? "type zeroGradient;"
                                   : "type pressureInletVelocity; value uniform (0 0 0);";
  return {fmt::format("type fixedValue; value uniform {};", (open->value - units.lower_pressure) / units.pressure),
          velocity};
}

} // namespace

Units units_of(const pfv::Case& problem) {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const pfv::FaceCondition& condition : problem.faces)
    if (const auto* open = std::get_if<pfv::Pressure>(&condition)) {
      lowest = std::min(lowest, open->value);
      highest = std::max(highest, open->value);
    }
  return {problem.packing.box.size().maxCoeff(), std::max(0.0, highest - lowest), lowest, problem.fluid.viscosity};
}

pfv::Packing in_units(const pfv::Packing& packing, const Units& units) {
  pfv::Packing scaled{{packing.box.lower / units.length, packing.box.upper / units.length}, packing.spheres};
  for (pfv::Sphere& sphere : scaled.spheres)
    sphere = {sphere.centre / units.length, sphere.radius / units.length};
  return scaled;
}

void write_foam_file(const std::filesystem::path& file, std::string_view kind, std::string_view text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream out(file);
  out << "FoamFile { version 2.0; format ascii; class " << kind << "; object " << file.filename().string() << "; }\n"
      << text;
  if (!out.flush())
    throw pfv::SolveError("cannot write " + file.string());
}

void write_decomposition(const std::filesystem::path& folder, const pfv::Box& box, int ranks) {
  int longest = 0;
  box.size().maxCoeff(&longest);
  std::array<int, 3> slices{1, 1, 1};
  slices[static_cast<std::size_t>(longest)] = ranks;
  write_foam_file(folder / "system" / "decomposeParDict", "dictionary",
                  fmt::format("numberOfSubdomains {}; method simple;\nsimpleCoeffs {{ n ({} {} {}); delta 0.001; }}\n",
                              ranks, slices[0], slices[1], slices[2]));
}

void write_dictionaries(const std::filesystem::path& folder, const std::vector<std::string>& open_faces,
                        const SolverSettings& settings) {
  std::string functions;
  for (const std::string& name : open_faces)
    functions += fmt::format(flux_history, fmt::arg("name", name));
  write_foam_file(folder / "system" / "controlDict", "dictionary",
                  fmt::format(control, fmt::arg("iterations", iteration_limit), fmt::arg("functions", functions)));
  write_foam_file(folder / "system" / "fvSchemes", "dictionary",
                  fmt::format(schemes, fmt::arg("gradient", settings.gradient)));
  write_foam_file(
      folder / "system" / "fvSolution", "dictionary",
      fmt::format(solution, fmt::arg("tolerance", settings.tolerance), fmt::arg("relaxation", settings.relaxation)));
  write_foam_file(folder / "constant" / "transportProperties", "dictionary",
                  fmt::format("transportModel Newtonian; nu {};\n", Units::viscosity));
  write_foam_file(folder / "constant" / "turbulenceProperties", "dictionary", "simulationType laminar;\n");
}

void write_fields(const std::filesystem::path& folder, const FoamMesh& mesh, const pfv::Case& problem) {
  const Units units = units_of(problem);
  std::string pressure;
  std::string velocity;
  for (const MeshPatch& patch : mesh.patches) {
    const Boundary conditions = boundary(patch.part, problem.faces, units);
    pressure += fmt::format("  {} {{ {} }}\n", patch.name, conditions.pressure);
    velocity += fmt::format("  {} {{ {} }}\n", patch.name, conditions.velocity);
  }
  write_foam_file(folder / "0" / "p", "volScalarField",
                  "dimensions [0 2 -2 0 0 0 0];\ninternalField uniform 0;\nboundaryField {\n" + pressure + "}\n");
  write_foam_file(folder / "0" / "U", "volVectorField",
                  "dimensions [0 1 -1 0 0 0 0];\ninternalField uniform (0 0 0);\nboundaryField {\n" + velocity + "}\n");
}

} // namespace reference::openfoam
