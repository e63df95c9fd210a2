#include "reference/stokes_fem/flow_on_mesh.hpp"

#include "meshing/periodic_images.hpp"
#include "reference/stokes_fem/forces.hpp"
#include "reference/stokes_fem/sample.hpp"
#include "reference/stokes_fem/solve_on_ranks.hpp"
#include "reference/stokes_fem/stokes_solver.hpp"
#include "reference/stokes_fem/unit_case.hpp"

#include <algorithm>
#include <cmath>

namespace reference::stokes_fem {

namespace {

void add_flow(const pfv::Case& problem, const UnitCase& unit, const StokesSolution& solution, Answer& answer) {
  for (std::size_t face = 0; face < 6; ++face)
    answer.face_flux[face] = solution.face_flux[face] * unit.flux();
  // The flux that dissipates what the pressures put in: its error is of twice the order of a flux through one face.
  if (const auto setup = pfv::permeability_setup(problem))
    answer.permeability = problem.fluid.viscosity * solution.dissipation * unit.flux() * setup->length /
                          (setup->area * std::abs(*setup->pressure_drop));
}

// The lowest pressure face has its own; without one the mean over the fluid is that of a pressure that is zero in the
// middle of the box and has the mean gradient.
void set_level(const UnitCase& unit, const StokesSystem& system, Eigen::VectorXd& pressure) {
  const bool has_level =
      std::ranges::any_of(unit.driving, [](const auto& face) { return std::holds_alternative<pfv::Pressure>(face); });
  if (has_level)
    pressure.array() += unit.lowest_pressure;
  else
    pressure.array() -= pressure.dot(system.pressure_volume) / system.pressure_volume.sum();
}

void add_forces(const Forces& forces, double unit, Answer& answer) {
  const auto in_si = [unit](std::vector<pfv::Vec3> list) {
    for (pfv::Vec3& force : list)
      force *= unit;
    return list;
  };
  answer.sphere_forces = in_si(forces.sphere);
  answer.sphere_viscous_forces = in_si(forces.viscous);
  answer.wall_forces.emplace();
  for (std::size_t face = 0; face < 6; ++face)
    (*answer.wall_forces)[face] = unit * forces.wall[face];
}

void add_counts(const MeshFacts& mesh, const StokesSolution& solution, Answer& answer) {
  answer.unknowns = 3 * mesh.velocity_nodes + mesh.pressure_nodes;
  answer.counts["free_unknowns"] = static_cast<double>(solution.free_velocities + mesh.pressure_nodes);
  answer.counts["cells"] = static_cast<double>(mesh.cells);
  answer.counts["curved_cells"] = static_cast<double>(mesh.curved_cells);
  answer.counts["straightened_cells"] = static_cast<double>(mesh.straightened_cells);
  answer.counts["factor_entries"] = solution.factor_entries;
  answer.counts["iterations"] = solution.iterations;
  answer.counts["residual"] = solution.residual;
  answer.counts["momentum_residual"] = solution.momentum_residual;
  answer.counts["velocity_iterations"] = solution.velocity_iterations;
  answer.counts["flux_imbalance"] = solution.imbalance;
}

void add_ranks(const SharedSolve& shared, double memory, Answer& answer) {
  answer.counts["ranks"] = shared.ranks;
  answer.counts.erase("factor_entries"); // nothing is factored
  answer.counts[memory_count] = std::max(memory, static_cast<double>(pfv::peak_memory_bytes()));
  answer.notes["solver"] =
      "MINRES on ranks (PETSc), BoomerAMG cycles for velocities and in the scaled BFBt preconditioner";
}

} // namespace

Answer flow_on_mesh(const pfv::Case& problem, const std::filesystem::path& mesh, double bridge_radius,
                    pfv::Clock& clock, const Probes& probes, const Solve& solve) {
  const meshing::ImagedPacking imaged = meshing::with_images(problem.packing, periodic_axes(problem.faces));
  pfv::Case seen = problem;
  seen.packing = imaged.packing;
  const UnitCase unit = unit_case(seen);
  Answer answer;
  // Before this process holds a mesh of its own, for which the ranks' memory may be needed.
  std::optional<FlowOnRanks> from_ranks;
  const auto* shared = std::get_if<SharedSolve>(&solve);
  if (shared)
    from_ranks = solve_on_ranks(problem, mesh, bridge_radius, shared->ranks, shared->wall_limit, clock);
  std::shared_ptr<const Discretisation> space;
  StokesSystem system;
  Boundary boundary;
  {
    const auto timing = clock.stage("assemble");
    space = discretise(mesh, unit.problem, unit.origin, unit.length, bridge_radius);
    boundary = make_boundary(*space, unit.driving);
    system = assemble(*space);
  }
  StokesSolution solution = from_ranks
                                ? std::move(from_ranks->solution)
                                : solve_stokes(system, boundary, unit.driving, std::get<SolverSettings>(solve), clock);
  {
    const auto timing = clock.stage("forces");
    set_level(unit, system, solution.flow.pressure);
    add_forces(fluid_forces(*space, system, boundary, unit.problem, imaged, solution.flow, bridge_radius), unit.force(),
               answer);
  }
  if (!probes.empty()) {
    const auto timing = clock.stage("sample");
    sample(flow_mesh(*space, solution.flow), unit, probes, answer);
  }
  add_flow(problem, unit, solution, answer);
  answer.porosity = system.pressure_volume.sum() / unit.problem.packing.box.volume();
  add_counts(facts(*space), solution, answer);
  answer.notes["library"] = element_library();
  answer.notes["element"] = "Taylor-Hood P2/P1 on curved tetrahedra";
  if (from_ranks)
    add_ranks(*shared, from_ranks->peak_memory, answer);
  else
    answer.notes["solver"] =
        std::string("CG on the Schur complement, scaled BFBt preconditioner, ") +
        (std::holds_alternative<Direct>(std::get<SolverSettings>(solve).inner) ? "solves by CHOLMOD"
                                                                               : "solves by CG with multigrid");
  return answer;
}

} // namespace reference::stokes_fem
