#pragma once

#include "pfv/flow/flow_solver.hpp"

namespace pfv {

std::unique_ptr<FlowSolver> make_cholmod();

} // namespace pfv
