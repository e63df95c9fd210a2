#include "reference/openfoam/openfoam.hpp"

#include "meshing/contact_bridges.hpp"
#include "meshing/exact_void.hpp"
#include "pfv/problem/error.hpp"
#include "reference/openfoam/bridge_radius.hpp"
#include "reference/openfoam/case_files.hpp"
#include "reference/openfoam/convergence.hpp"
#include "reference/openfoam/fill_out_spheres.hpp"
#include "reference/openfoam/flow_fields.hpp"
#include "reference/openfoam/fluid_forces.hpp"
#include "reference/openfoam/mesh_route.hpp"
#include "reference/openfoam/programs.hpp"
#include "reference/openfoam/sample.hpp"
#include "reference/temporary_folder.hpp"
#include "reference/walls_and_pressures.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace reference {

namespace {

using namespace openfoam;

constexpr double largest_imbalance = 1e-5;
constexpr double largest_drift = 2e-3;
constexpr double largest_volume_error = 0.03;

std::vector<std::string> open_faces(const pfv::FaceConditions& faces) {
  std::vector<std::string> names;
  for (std::size_t face = 0; face < faces.size(); ++face)
    if (std::holds_alternative<pfv::Pressure>(faces[face]))
      names.emplace_back(pfv::face_names[face]);
  return names;
}

// The meshers' numbering jumps through memory: renumbering makes the solve a quarter faster.
FoamMesh finish(const std::filesystem::path& folder, const MeshRoute::Made& made, const pfv::Case& problem,
                pfv::Clock& clock) {
  clock.add("convert", run_program(folder, {"renumberMesh", "-overwrite"}).cpu_seconds);
  const auto timing = clock.stage("convert");
  const Units units = units_of(problem);
  FoamMesh mesh = read_mesh(folder);
  for (pfv::Vec3& point : mesh.points)
    point *= made.unit / units.length;
  mesh.cell_centres = cell_centres(mesh);
  fill_out_spheres(mesh, in_units(problem.packing, units));
  write_points(folder, mesh);
  return mesh;
}

// simpleFoam, the last fields in the case folder whatever the number of ranks.
meshing::ChildResult run_solver(const std::filesystem::path& folder, const pfv::Box& box, int ranks,
                                pfv::Clock& clock) {
  if (ranks == 1) {
    const auto run = run_program(folder, {"simpleFoam"});
    clock.add("solve", run.cpu_seconds);
    return run;
  }
  write_decomposition(folder, box, ranks);
  clock.add("convert", run_program(folder, {"decomposePar"}).cpu_seconds);
  const auto run = run_on_ranks(folder, "simpleFoam", ranks);
  clock.add("solve", run.cpu_seconds);
  clock.add("convert", run_program(folder, {"reconstructPar", "-latestTime"}).cpu_seconds);
  return run;
}

class OpenFoam : public Method {
public:
  explicit OpenFoam(std::unique_ptr<openfoam::MeshRoute> route) : route_(std::move(route)) {}

  std::string name() const override { return route_->method_name(); }
  std::string description() const override { return route_->description(); }
  std::string version() const override {
    const std::string mesher = route_->version();
    return mesher.empty() ? program_version() : fmt::format("{}, {}", program_version(), mesher);
  }
  std::vector<std::string> built_from() const override { return {"pfv/problem", "meshing", "reference/openfoam"}; }

  std::optional<std::string> unavailable() const override {
    const auto reason = missing_programs();
    return reason ? reason : route_->unavailable();
  }
  std::optional<std::string> not_covered(const pfv::Case& problem) const override {
    if (const auto what = beyond_walls_and_pressures(problem))
      return what;
    if (!(units_of(problem).pressure > 0))
      return "no two faces have different pressures";
    return std::nullopt;
  }
  std::optional<double> convergence_order() const override { return route_->convergence_order(); }
  bool runs_on_ranks() const override { return true; }
  Estimate estimate(const pfv::Case& problem, const Request& request) const override;
  Answer solve(const pfv::Case& problem, const Request& request, pfv::Clock& clock) const override;

private:
  std::unique_ptr<openfoam::MeshRoute> route_;
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
  answer.sphere_viscous_forces = forces.viscous;
  answer.wall_forces = forces.on_faces;
  return answer;
}

// How much more fluid the mesh holds than the packing, bridges aside, as a fraction. Throws when it is another
// packing's.
double volume_error(const pfv::Case& problem, const FoamMesh& mesh) {
  const double found = volume(mesh) * std::pow(units_of(problem).length, 3);
  const double error = found / meshing::exact_void(problem.packing).volume - 1;
  if (std::abs(error) < largest_volume_error)
    return error;
  throw pfv::SolveError(
      fmt::format("the mesh holds {:.1f} % {} fluid than there is between the spheres (at most {:.0f} %): it has "
                  "{} cells, too few for this packing",
                  100 * std::abs(error), error > 0 ? "more" : "less", 100 * largest_volume_error, mesh.cells()));
}

Answer OpenFoam::solve(const pfv::Case& problem, const Request& request, pfv::Clock& clock) const {
  if (const auto reason = unavailable())
    throw pfv::SolveError(name() + " is unavailable: " + *reason);
  if (const auto reason = not_covered(problem))
    throw pfv::SolveError(name() + " does not cover this case: " + *reason);
  const TemporaryFolder folder("openfoam");
  const auto faces = open_faces(problem.faces);
  write_dictionaries(folder.path(), faces, route_->solver());
  const auto made = route_->make(folder.path(), problem, request.mesh_size, clock);
  const FoamMesh mesh = finish(folder.path(), made, problem, clock);
  const double excess = volume_error(problem, mesh);
  write_fields(folder.path(), mesh, problem);
  const auto run = run_solver(folder.path(), problem.packing.box, request.ranks, clock);
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
    const auto bridges = meshing::contact_bridges(problem.packing, bridge_radius);
    answer = answer_in_si(problem, fields, fluid_forces(mesh, fields, problem, bridges));
  }
  if (!request.probes.empty()) {
    const auto timing = clock.stage("sample");
    Samples samples = sample(mesh, fields, problem, request.probes);
    answer.point_pressures = std::move(samples.point_pressures);
    answer.facet_fluxes = std::move(samples.facet_fluxes);
  }
  answer.method = name();
  answer.mesh_size = request.mesh_size;
  answer.unknowns = 4 * mesh.cells();
  answer.porosity = volume(mesh) * std::pow(units_of(problem).length, 3) / problem.packing.box.volume();
  answer.stages = clock.stages();
  answer.counts = made.counts;
  answer.counts.insert({{"cells", static_cast<double>(mesh.cells())},
                        {"volume_error", excess},
                        {"iterations", convergence.iterations},
                        {"flux_imbalance", imbalance},
                        {"flux_drift", convergence.flux_drift},
                        {"non_orthogonality", non_orthogonality(mesh)},
                        {"solver_memory_bytes", static_cast<double>(run.peak_memory_bytes)}});
  answer.notes = {{"version", version()}, {"mesh", made.note}};
  return answer;
}

Estimate OpenFoam::estimate(const pfv::Case& problem, const Request& request) const {
  const double cells = route_->cells(problem, request.mesh_size);
  return {4 * cells, route_->seconds_per_cell() * cells, 1e8 + 2200 * cells};
}

} // namespace

std::unique_ptr<Method> make_openfoam() {
  return std::make_unique<OpenFoam>(make_gmsh_route());
}

std::unique_ptr<Method> make_openfoam_snappy() {
  return std::make_unique<OpenFoam>(make_snappy_route());
}

} // namespace reference
