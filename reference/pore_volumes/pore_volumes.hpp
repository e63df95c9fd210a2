#pragma once

#include "reference/method.hpp"

namespace reference {

/// The pore-scale finite-volume model itself, as one method among the others: one pore per tetrahedron of the regular
/// triangulation, one conductance per facet, one sparse solve.
std::unique_ptr<Method> make_pore_volumes();

} // namespace reference
