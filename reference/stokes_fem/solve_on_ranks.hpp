#pragma once

#include "pfv/clock.hpp"
#include "pfv/problem/case.hpp"
#include "reference/stokes_fem/ranks_reply.hpp"

#include <filesystem>
#include <optional>

namespace reference::stokes_fem {

struct FlowOnRanks {
  StokesSolution solution;
  double peak_memory = 0; // bytes, all ranks
};

/// Why this build cannot share a flow between ranks; nothing when it can.
std::optional<std::string> missing_ranks_program();

/// The flow of flow_on_mesh() by the program stokes_ranks (`$PFV_STOKES_RANKS` or this build's), which mpirun starts
/// when ranks are more than one, in the numbers of discretise() for the same mesh. Adds "assemble", "factor" and
/// "solve" of all ranks. Throws pfv::SolveError with the cause when a rank fails, dies, or the limit (s) passes.
FlowOnRanks solve_on_ranks(const pfv::Case& problem, const std::filesystem::path& mesh, double bridge_radius, int ranks,
                           double wall_limit, pfv::Clock& clock);

} // namespace reference::stokes_fem
