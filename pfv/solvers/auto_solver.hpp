#pragma once

#include "pfv/solvers/flow_solver.hpp"

namespace pfv {

/// Cholmod for small systems, Multigrid for the others; decides in `analyse`.
std::unique_ptr<FlowSolver> make_auto_solver(const AutoSolver& parameters);

} // namespace pfv
