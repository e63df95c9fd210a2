#include "reference/lattice_boltzmann/lattice_boltzmann.hpp"

#include "pfv/problem/error.hpp"
#include "reference/lattice_boltzmann/expected_cost.hpp"
#include "reference/lattice_boltzmann/program.hpp"
#include "reference/lattice_boltzmann/translate.hpp"
#include "reference/lattice_boltzmann/velocities.hpp"

#include <cmath>
#include <fmt/format.h>

namespace reference {

namespace {

using namespace lattice_boltzmann;

class LatticeBoltzmann final : public Method {
public:
  std::string name() const override { return "lattice_boltzmann"; }
  std::string description() const override {
    return "Stokes flow by the lattice Boltzmann method on cubic voxels (Palabos)";
  }
  std::string version() const override { return PALABOS_VERSION; }
  std::vector<std::string> built_from() const override {
    return {"pfv/problem", "meshing", "reference/lattice_boltzmann"};
  }

  std::optional<std::string> unavailable() const override { return missing_program(); }
  std::optional<std::string> not_covered(const pfv::Case& problem) const override { return beyond_lattice(problem); }
  /// Of the scheme. What is left on lattices, 0.5 % from mesh size 0.7 on where no gap is thinner than two voxels,
  /// falls unevenly: spheres lie differently to the voxels at each size. Gaps of one voxel converge with the first
  /// order.
  std::optional<double> convergence_order() const override { return 2; }
  bool runs_on_ranks() const override { return true; }
  Estimate estimate(const pfv::Case& problem, const Request& request) const override {
    return expected_cost(problem, voxel_grid(problem.packing, request.mesh_size), request.ranks);
  }
  Answer solve(const pfv::Case& problem, const Request& request, pfv::Clock& clock) const override;
};

void require_rest(const FlowQuestion& question, const FlowReply& reply) {
  if (!reply.settled)
    throw pfv::SolveError(
        fmt::format("the flow has not come to rest in {} steps: {:.2g} of it still to come and {:.2g} "
                    "of the force not taken up (at most {:.2g})",
                    reply.steps, reply.drift, reply.balance, question.tolerance));
}

Answer LatticeBoltzmann::solve(const pfv::Case& problem, const Request& request, pfv::Clock& clock) const {
  if (const auto reason = unavailable())
    throw pfv::SolveError("lattice_boltzmann is unavailable: " + *reason);
  if (const auto reason = not_covered(problem))
    throw pfv::SolveError("lattice_boltzmann does not cover this case: " + *reason);
  const VoxelGrid grid = voxel_grid(problem.packing, request.mesh_size);
  if (grid.misfit > largest_misfit)
    throw pfv::SolveError(fmt::format("cubic voxels misfit the sides of the box by {:.2g} at mesh size {}", grid.misfit,
                                      request.mesh_size));
  const FlowQuestion question = question_of(problem, grid, request.probes);
  const Estimate expected = expected_cost(problem, grid, request.ranks);
  const FlowReply reply = run_lattice_flow(question, request.ranks, 120 + 20 * expected.cpu_seconds);
  require_rest(question, reply);
  clock.add("mesh", reply.voxel_seconds);
  clock.add("solve", reply.solve_seconds);

  Answer answer = answer_in_si(problem, grid, question, reply, request.probes);
  const auto [least, most] = reply.section_velocity;
  answer.method = name();
  answer.mesh_size = request.mesh_size;
  answer.unknowns = directions * reply.fluid_voxels;
  answer.stages = clock.stages();
  answer.counts = {{"voxels", grid.count()},
                   {"fluid_voxels", static_cast<double>(reply.fluid_voxels)},
                   {"pocket_voxels", static_cast<double>(reply.pocket_voxels)},
                   {"links", static_cast<double>(reply.links)},
                   {"narrow_links", static_cast<double>(reply.narrow_links)},
                   {"misfit", grid.misfit},
                   {"steps", reply.steps},
                   {"flux_imbalance", (most - least) / reply.velocity},
                   {"force_imbalance", std::abs(reply.balance)},
                   {"drift", reply.drift},
                   {memory_count, reply.peak_memory}};
  answer.notes = {{"version", version()},
                  {"lattice", "D3Q19, two relaxation times, linear equilibrium: Reynolds number zero"},
                  {"relaxation", fmt::format("viscosity {:.4g}, magic parameter {:.4g} in lattice units",
                                             question.viscosity, question.magic)},
                  {"spheres", "central linear interpolation, half-way bounce-back in gaps of one voxel"},
                  {"flux", "mean over all sections; its spread between them is flux_imbalance"}};
  return answer;
}

} // namespace

std::unique_ptr<Method> make_lattice_boltzmann() {
  return std::make_unique<LatticeBoltzmann>();
}

} // namespace reference
