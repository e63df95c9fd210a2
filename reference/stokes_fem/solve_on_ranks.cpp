#include "reference/stokes_fem/solve_on_ranks.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "reference/ranks.hpp"
#include "reference/temporary_folder.hpp"

#include <fmt/format.h>
#include <fstream>

namespace reference::stokes_fem {

namespace {

SolverProgram stokes_ranks() {
  return {"stokes_ranks", "PFV_STOKES_RANKS", STOKES_RANKS_PATH};
}

} // namespace

std::optional<std::string> missing_ranks_program() {
  const std::filesystem::path program = stokes_ranks().path();
  if (program.empty())
    return "this build's deal.II has no PETSc with hypre and MUMPS";
  if (!std::filesystem::exists(program))
    return fmt::format("the program {} does not exist", program.string());
  return std::nullopt;
}

FlowOnRanks solve_on_ranks(const pfv::Case& problem, const std::filesystem::path& mesh, double bridge_radius, int ranks,
                           double wall_limit, pfv::Clock& clock) {
  if (const auto reason = missing_ranks_program())
    throw pfv::SolveError("stokes_fem cannot run on several ranks: " + *reason);
  const TemporaryFolder folder("stokes_ranks");
  std::ofstream(folder.path() / "case.toml") << pfv::to_toml(problem);
  stokes_ranks().run({std::filesystem::absolute(mesh).string(), fmt::format("{}", bridge_radius)}, folder.path(), ranks,
                     wall_limit);
  try {
    const RanksReply reply = ranks_reply_from_json(pfv::read_text(folder.path() / "reply.json"));
    clock.add("assemble", reply.assemble_seconds);
    clock.add("factor", reply.factor_seconds);
    clock.add("solve", reply.solve_seconds);
    return {{.flow = read_flow(folder.path() / "flow", reply.velocity_nodes, reply.pressure_nodes),
             .face_flux = reply.face_flux,
             .dissipation = reply.dissipation,
             .residual = reply.residual,
             .imbalance = reply.imbalance,
             .iterations = reply.iterations,
             .free_velocities = reply.free_velocities},
            reply.peak_memory};
  } catch (const std::exception& error) {
    throw pfv::SolveError(fmt::format("the reply of stokes_ranks cannot be read: {}", error.what()));
  }
}

} // namespace reference::stokes_fem
