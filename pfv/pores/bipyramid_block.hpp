#pragma once

#include "pfv/pores/facet_block.hpp"

namespace pfv {

/// The bipyramids on the facets of a block: each spanned by a facet and the centres of the pores behind and ahead of
/// it. Everything is signed: what lies on the wrong side of the facet counts against.
struct BipyramidBlock {
  using Lane = FacetBlock::Lane;

  struct Side {
    Lane x, y, z;             // m, the pore's centre
    Lane volume, void_volume; // m^3, of the pyramid
  };
  Side behind, ahead;

  Lane length;                // m, l
  Lane void_volume;           // m^3, Theta
  std::array<Lane, 3> wetted; // m^2, gamma by corner
  std::array<Lane, 3> ball;   // m^3, of the sphere at each corner
  Lane contrast;              // see pore_contrast

  /// From measured facets and the centres, everything else but contrasts.
  void measure(const FacetBlock& facets);
  void measure_contrasts(const FacetBlock& facets);
};

} // namespace pfv
