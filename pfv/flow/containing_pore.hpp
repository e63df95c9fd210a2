#pragma once

#include "pfv/pores/pore_network.hpp"

namespace pfv {

/// The pore whose cell contains a point of the box, and by how many boxes the point must be moved to lie in it; zero
/// unless the box is periodic. A point on a facet goes to one of the two pores. One pass over all throats, more where
/// cells reach across a periodic box.
struct ContainingPore {
  int pore;
  Shift shift;
};
ContainingPore containing_pore(const PoreNetwork& network, const Vec3& point);

} // namespace pfv
