#pragma once

#include "pfv/flow/flow_system.hpp"
#include "pfv/solvers/flow_solver.hpp"

namespace pfv {

/// Solves a factored system with its Flux faces at the pressures at which their fluxes pass, and sets these as the
/// known pressures of their pores. By superposition: the flow with all of them at zero, plus for each the flow with
/// that face at one and all else at zero; as many unknown pressures as such faces then follow from as many fluxes. So
/// the matrix stays as sparse and as definite as without them. `solution` holds a first guess, then the answer. Throws
/// SolveError when a flux has no way out.
void solve_with_flux_faces(const PoreNetwork& network, FlowSystem& system, FlowSolver& solver,
                           Eigen::VectorXd& solution);

} // namespace pfv
