#pragma once

#include "pfv/solvers/interpolation.hpp"

namespace pfv {

/// scale P' A P (Galerkin), summed in double precision.
template <class Value>
SparseRows coarse_matrix(const MatrixView<Value>& fine, const Interpolation& interpolation, double scale = 1);

} // namespace pfv
