#pragma once

#include "pfv/pores/triangulate.hpp"

namespace pfv {

/// The cells of a packing whose box repeats itself along some axes, each once, with the images they need among the
/// sites. The packing is in units of order 1, its box begins at (0, 0, 0). Throws SolveError when the cells do not
/// repeat.
Triangulation periodic_cells(const Packing& packing, const PeriodicAxes& periodic, Clock& clock);

} // namespace pfv
