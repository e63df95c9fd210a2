#pragma once

#include "reference/method.hpp"

namespace reference {

/// The pore-scale finite-volume model itself, as one method among the others: one pore per tetrahedron of the regular
/// triangulation, one conductance per facet, one sparse solve by Cholesky factorisation or
/// multigrid, whichever is faster for the size.
std::unique_ptr<Method> make_pore_volumes();

/// The same system solved by the over-relaxed Gauss-Seidel of Catalano et al. 2011: the historical row.
std::unique_ptr<Method> make_pore_volumes_sor();

/// The same system by multigrid, left off where a step of a moving packing by frozen conductances is no nearer to the
/// truth: pressures to 1e-6 instead of 1e-10.
std::unique_ptr<Method> make_pore_volumes_loose();

/// The model with the conductance rule `mixed-area`.
std::unique_ptr<Method> make_pore_volumes_mixed_area();

/// The model with the conductance rule `calibrated`.
std::unique_ptr<Method> make_pore_volumes_calibrated();

/// The model with the wall rule `original`, which is for comparison with YADE only.
std::unique_ptr<Method> make_pore_volumes_original_walls();

} // namespace reference
