#pragma once

#include "reference/lattice_boltzmann/flow_question.hpp"

#include <optional>

namespace reference::lattice_boltzmann {

/// Why the solver, which is a program of its own, cannot be run; nothing when it can.
std::optional<std::string> missing_program();

/// Asks the solver, `$PFV_LATTICE_FLOW`, else in ../libexec of the running program, else where it was built; on several
/// ranks by mpirun. It is stopped after `wall_limit` (s). Throws pfv::SolveError with its last words when it fails.
FlowReply run_lattice_flow(const FlowQuestion& question, int ranks, double wall_limit);

} // namespace reference::lattice_boltzmann
