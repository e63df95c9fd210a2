#pragma once

#include "pfv/pores/pore_network.hpp"
#include "pfv/problem/case.hpp"

#include <cstddef>
#include <vector>

namespace reference {

/// Where methods are asked for pressures and fluxes so that they can be compared place by place.
struct Probes {
  /// A flat convex polygon of three or four corners (m), counterclockwise seen against its normal.
  using Facet = std::vector<pfv::Vec3>;

  std::vector<pfv::Vec3> points; // m; in a periodic box they may lie outside it
  std::vector<Facet> facets;     // where they cross spheres nothing flows; in a periodic box they may reach outside it

  bool empty() const { return points.empty() && facets.empty(); }
};

/// The places PFV speaks of: `points` are the centres of its pores and then, from `lines` on, `points_per_line` points
/// on each of nine lines along the axis of the flow (z when there is not one), at the middle of equal intervals; the
/// lines stand on a 3 x 3 grid. `facets` are its throats, normals from pore i to pore j, cut at the walls of the box.
struct PoreProbes {
  static constexpr std::size_t points_per_line = 64;
  Probes probes;
  std::size_t lines = 0;
};
PoreProbes pore_probes(const pfv::Case& problem);
PoreProbes pore_probes(const pfv::Case& problem, const pfv::PoreNetwork& network);

/// Whether a point lies in a sphere; images are not looked at.
bool in_solid(const pfv::Packing& packing, const pfv::Vec3& point);

} // namespace reference
