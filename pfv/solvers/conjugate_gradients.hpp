#pragma once

#include "pfv/solvers/preconditioner.hpp"

#include <memory>
#include <string>

namespace pfv {

/// Preconditioned conjugate gradients (Hestenes & Stiefel 1952). The error e = p - A^-1 b before the last step
/// satisfies e.A e <= tolerance^2 p.b, both powers dissipated by flow (W), the first estimated by r.M r.
///
/// A preconditioner kept by `update` may take 30 steps; then it is built anew and the solve goes on from where it is.
std::unique_ptr<FlowSolver> make_conjugate_gradients(const std::string& name,
                                                     std::unique_ptr<Preconditioner> preconditioner, double tolerance);

} // namespace pfv
