#pragma once

#include "pfv/problem/generate.hpp"

#include <optional>
#include <vector>

namespace reference {

/// Drag coefficient of a periodic lattice of spheres: force per sphere, mean pressure gradient included, over
/// 3 pi mu d U, U the superficial velocity.
struct LatticeDrag {
  pfv::Lattice lattice;
  double solid_fraction;
  double coefficient;
  double relative_error; // of the coefficient: digits printed, or convergence of the computation
};

/// The table of lattice_drag.csv, compiled into the library, in its order.
const std::vector<LatticeDrag>& lattice_drag_table();

/// The row of this solid fraction, to a relative 1e-6; the last row of a lattice is that of touching spheres.
std::optional<LatticeDrag> lattice_drag(pfv::Lattice lattice, double solid_fraction);

} // namespace reference
