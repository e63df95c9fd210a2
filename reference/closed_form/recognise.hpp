#pragma once

#include "pfv/problem/generate.hpp"

#include <optional>
#include <vector>

namespace reference {

struct RecognisedLattice {
  pfv::Lattice lattice;
  int cells; // along a side
  double solid_fraction;
  std::vector<double> part_inside; // per sphere of the packing: 1, or 1/2, 1/4, 1/8 when faces cut it
};

/// Which pfv::lattice_packing this packing is, up to the order of spheres, the place of the box and a relative 1e-9 of
/// the cell; nothing when it is none. Along a periodic axis no sphere is cut.
std::optional<RecognisedLattice> recognise_lattice(const pfv::Packing& packing, const pfv::PeriodicAxes& periodic = {});

} // namespace reference
