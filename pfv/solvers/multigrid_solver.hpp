#pragma once

#include "pfv/solvers/preconditioner.hpp"

namespace pfv {

/// Conjugate gradients with one V-cycle of multigrid, a forward sweep of Gauss-Seidel before and a backward one after
/// the correction by the coarser level. Levels of single precision; the answer is of double precision all the same.
std::unique_ptr<FlowSolver> make_multigrid(const Multigrid& parameters);

/// The V-cycle alone.
std::unique_ptr<Preconditioner> make_v_cycle();

} // namespace pfv
