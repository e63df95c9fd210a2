#pragma once

#include "pfv/solvers/flow_solver.hpp"

namespace pfv {

/// Supernodal or simplicial Cholesky factorisation, ordered by CHOLMOD (Chen et al. 2008): its answer, refined once.
std::unique_ptr<FlowSolver> make_cholmod();

} // namespace pfv
