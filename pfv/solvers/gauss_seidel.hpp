#pragma once

#include "pfv/solvers/flow_solver.hpp"

namespace pfv {

/// p_i <- (1 - w) p_i + w (b_i - sum_{j != i} A_ij p_j) / A_ii, pore after pore, until the residual meets the
/// tolerance. Throws InputError unless 0 < w < 2. Without a given w it starts at 1.9 and follows Young's optimum 2 / (1
/// + sqrt(1 - rho^2)), the spectral radius rho of the Jacobi iteration estimated from the decay lambda of the steps,
/// rho = (lambda + w - 1) / (w sqrt(lambda)) (Hageman & Young 1981, Applied Iterative Methods, ch. 9).
std::unique_ptr<FlowSolver> make_gauss_seidel(const GaussSeidel& parameters);

} // namespace pfv
