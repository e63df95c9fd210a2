#pragma once

#include "pfv/flow/flow_solver.hpp"

namespace pfv {

/// p_i <- (1 - w) p_i + w (b_i - sum_{j != i} A_ij p_j) / A_ii, pore after pore, until the residual meets the tolerance.
/// Throws InputError unless 0 < w < 2.
std::unique_ptr<FlowSolver> make_gauss_seidel(const GaussSeidel& parameters);

} // namespace pfv
