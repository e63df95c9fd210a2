#include "reference/openfoam/openfoam.hpp"

#include "meshing/contact_bridges.hpp"
#include "meshing/void_mesh.hpp"
#include "pfv/problem/error.hpp"
#include "reference/openfoam/case_files.hpp"
#include "reference/openfoam/convergence.hpp"
#include "reference/openfoam/fill_out_spheres.hpp"
#include "reference/openfoam/flow_fields.hpp"
#include "reference/openfoam/fluid_forces.hpp"
#include "reference/openfoam/programs.hpp"
#include "reference/temporary_folder.hpp"
#include "reference/walls_and_pressures.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace reference {

namespace {

using namespace openfoam;

// Of the default mesh, made for quadratic elements. With it the permeability of touching lattices is 2 to 5 % high, and
// within 1 % when extrapolated from 1.5 and 1.
constexpr double finer_mesh = 0.5;
constexpr double largest_imbalance = 1e-5;
constexpr double largest_drift = 2e-3;

std::vector<std::string> open_faces(const pfv::FaceConditions& faces) {
  std::vector<std::string> names;
  for (std::size_t face = 0; face < faces.size(); ++face)
    if (std::holds_alternative<pfv::Pressure>(faces[face]))
      names.emplace_back(pfv::face_names[face]);
  return names;
}

meshing::MeshSettings mesh_settings(const Request& request) {
  meshing::MeshSettings settings;
  settings.mesh_size = finer_mesh * request.mesh_size;
  return settings;
}

pfv::Packing in_units(const pfv::Packing& packing, const Units& units) {
  pfv::Packing scaled{{packing.box.lower / units.length, packing.box.upper / units.length}, packing.spheres};
  for (pfv::Sphere& sphere : scaled.spheres)
    sphere = {sphere.centre / units.length, sphere.radius / units.length};
  return scaled;
}

// gmsh's numbering jumps through memory: renumbering makes the solve a quarter faster.
FoamMesh convert(const std::filesystem::path& folder, const meshing::VoidMesh& void_mesh, const pfv::Case& problem,
                 pfv::Clock& clock) {
  double cpu = run_program(folder, {"gmshToFoam", void_mesh.file.string()}).cpu_seconds;
  cpu += run_program(folder, {"renumberMesh", "-overwrite"}).cpu_seconds;
  clock.add("convert", cpu);
  const auto timing = clock.stage("convert");
  const Units units = units_of(problem);
  FoamMesh mesh = read_mesh(folder);
  for (pfv::Vec3& point : mesh.points)
    point /= units.length;
  fill_out_spheres(mesh, in_units(problem.packing, units));
  write_points(folder, mesh);
  return mesh;
}

class OpenFoam : public Method {
public:
  std::string name() const override { return "openfoam"; }
  std::string description() const override {
    return "Stokes flow by finite volumes on linear tetrahedra (OpenFOAM's simpleFoam)";
  }
  std::string version() const override { return fmt::format("{}, {}", program_version(), meshing::mesher_version()); }
  std::optional<std::string> unavailable() const override {
    const auto reason = missing_programs();
    return reason ? reason : meshing::mesher_unavailable();
  }
  std::optional<std::string> not_covered(const pfv::Case& problem) const override {
    if (const auto what = beyond_walls_and_pressures(problem))
      return what;
    if (!(units_of(problem).pressure > 0))
      return "no two faces have different pressures";
    return std::nullopt;
  }
  /// Measured from mesh_size 1.5 to 1 on touching lattices: 2.0 (FCC) to 2.4 (simple cubic).
  std::optional<double> convergence_order() const override { return 2; }
  Estimate estimate(const pfv::Case& problem, const Request& request) const override;
  Answer solve(const pfv::Case& problem, const Request& request, pfv::Clock& clock) const override;
};

Answer answer_in_si(const pfv::Case& problem, const FlowFields& fields, const FluidForces& forces) {
  const Units units = units_of(problem);
  Answer answer;
  for (std::size_t face = 0; face < 6; ++face)
    answer.face_flux[face] = units.flux() * fields.face_flux[face];
  if (const auto setup = pfv::permeability_setup(problem)) {
    const auto lower = static_cast<std::size_t>(2 * pfv::index(setup->axis));
    const double flux = (answer.face_flux[lower] - answer.face_flux[lower + 1]) / 2;
    answer.permeability = problem.fluid.viscosity * flux * setup->length / (setup->area * *setup->pressure_drop);
  }
  answer.sphere_forces = forces.on_spheres;
  answer.wall_forces = forces.on_faces;
  return answer;
}

Answer OpenFoam::solve(const pfv::Case& problem, const Request& request, pfv::Clock& clock) const {
  if (const auto reason = unavailable())
    throw pfv::SolveError("openfoam is unavailable: " + *reason);
  if (const auto reason = not_covered(problem))
    throw pfv::SolveError("openfoam does not cover this case: " + *reason);
  const auto settings = mesh_settings(request);
  const auto void_mesh = meshing::void_mesh(problem, settings, meshing::default_mesh_cache());
  clock.add("mesh", void_mesh.cpu_seconds);

  const TemporaryFolder folder("openfoam");
  const auto faces = open_faces(problem.faces);
  write_dictionaries(folder.path(), faces);
  const FoamMesh mesh = convert(folder.path(), void_mesh, problem, clock);
  write_fields(folder.path(), mesh, problem);
  const auto run = run_program(folder.path(), {"simpleFoam"});
  clock.add("solve", run.cpu_seconds);
  const Convergence convergence = read_convergence(folder.path(), faces);
  const FlowFields fields = read_fields(folder.path(), convergence.iterations, mesh);
  const double imbalance = flux_imbalance(fields.face_flux);
  if (!(imbalance < largest_imbalance && convergence.flux_drift < largest_drift))
    throw pfv::SolveError(
        fmt::format("simpleFoam's flux has not settled: imbalance {:.2g} (at most {:.2g}), drift over "
                    "the last tenth of {} iterations {:.2g} (at most {:.2g})",
                    imbalance, largest_imbalance, convergence.iterations, convergence.flux_drift, largest_drift));
  Answer answer;
  {
    const auto timing = clock.stage("forces");
    const auto bridges = meshing::contact_bridges(problem.packing, settings.bridge_radius);
    answer = answer_in_si(problem, fields, fluid_forces(mesh, fields, problem, bridges));
  }
  answer.method = name();
  answer.mesh_size = request.mesh_size;
  answer.unknowns = 4 * mesh.cells();
  answer.porosity = volume(mesh) * std::pow(units_of(problem).length, 3) / problem.packing.box.volume();
  answer.stages = clock.stages();
  answer.counts = {{"cells", static_cast<double>(mesh.cells())},
                   {"iterations", convergence.iterations},
                   {"flux_imbalance", imbalance},
                   {"flux_drift", convergence.flux_drift},
                   {"non_orthogonality", non_orthogonality(mesh)},
                   {"bridges", static_cast<double>(void_mesh.quality.bridges)},
                   {"solver_memory_bytes", static_cast<double>(run.peak_memory_bytes)}};
  answer.notes = {
      {"version", version()},
      {"mesh", fmt::format("gmsh, linear tetrahedra, {} times the default element size", settings.mesh_size)}};
  return answer;
}

// Spheres centred on faces of the box count by the part inside.
double spheres_inside(const pfv::Packing& packing) {
  const double near = 1e-9 * packing.box.size().maxCoeff();
  double sum = 0;
  for (const pfv::Sphere& sphere : packing.spheres) {
    const auto on_faces = ((sphere.centre - packing.box.lower).array().abs() < near).count() +
                          ((packing.box.upper - sphere.centre).array().abs() < near).count();
    sum += std::pow(0.5, static_cast<double>(on_faces));
  }
  return sum;
}

// Fitted to lattices, nine spheres and 30 random ones from 8e3 to 2e5 cells: the mesh grades, so cells grow with less
// than the cube.
Estimate OpenFoam::estimate(const pfv::Case& problem, const Request& request) const {
  const double cells = 35000 * spheres_inside(problem.packing) * std::pow(request.mesh_size, -2.6);
  return {4 * cells, 2.5e-4 * cells, 1e8 + 1300 * cells};
}

} // namespace

std::unique_ptr<Method> make_openfoam() {
  return std::make_unique<OpenFoam>();
}

} // namespace reference
