#pragma once

#include "pfv/solvers/flow_solver.hpp"

namespace pfv {

/// Conjugate gradients with one V-cycle of BoomerAMG (hypre): HMIS coarsening and extended+i interpolation of at most
/// four entries per row (De Sterck et al. 2008), Gauss-Seidel forward on the way down and backward on the way up.
/// Initialises MPI when nobody has, and then finalises it when the program ends. Throws SolveError when hypre reports
/// one.
std::unique_ptr<FlowSolver> make_amg(const Amg& parameters);

} // namespace pfv
