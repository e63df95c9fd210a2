#pragma once

#include "pfv/solvers/gram_term.hpp"
#include "pfv/solvers/interpolation.hpp"

namespace pfv {

/// scale (P' A P + S) (Galerkin), summed in double precision. S, of the coarse rows, may be empty. Numbers the coarse
/// rows anew, in the interpolation too: see RowOrder.
template <class Value>
SparseRows coarse_matrix(const MatrixView<Value>& fine, Interpolation& interpolation, double scale = 1,
                         const GramTerm& term = {});

} // namespace pfv
