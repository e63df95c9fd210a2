#pragma once

#include "pfv/solvers/gram_term.hpp"
#include "pfv/solvers/preconditioner.hpp"

namespace pfv {

/// Conjugate gradients with one V-cycle of multigrid, a forward sweep of Gauss-Seidel before and a backward one after
/// the correction by the coarser level. Levels of single precision; the answer is of double precision all the same.
std::unique_ptr<FlowSolver> make_multigrid(const Multigrid& parameters);

/// The V-cycle alone, of the matrix, or of the matrix and a term, which outlives its use and may change with the
/// matrix. Measured on pores between grains that move, ten and a hundred times the explicit limit: half of the
/// iterations that the V-cycle of the matrix alone takes, each for a fourth more.
std::unique_ptr<Preconditioner> make_v_cycle(const GramTerm* term = nullptr);

} // namespace pfv
