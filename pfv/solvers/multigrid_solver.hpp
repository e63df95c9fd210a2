#pragma once

#include "pfv/solvers/flow_solver.hpp"

namespace pfv {

/// Conjugate gradients with one V-cycle of multigrid, a forward sweep of Gauss-Seidel before and a backward one after
/// the correction by the coarser level. Steps are of single precision, and residuals taken anew in double precision
/// keep them on their way ("reliable updates", Sleijpen & van der Vorst 1996): the answer is of double precision. Where
/// single precision does not get there, conductances spanning too many decades, double precision goes on.
std::unique_ptr<FlowSolver> make_multigrid(const Multigrid& parameters);

} // namespace pfv
