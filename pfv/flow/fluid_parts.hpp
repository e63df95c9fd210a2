#pragma once

#include "pfv/pores/pore_network.hpp"
#include "pfv/pores/throat_measures.hpp"

#include <array>

namespace pfv {

/// m^2, what each vertex of a throat takes of its fluid area S_f: by wetted surface, of a wall `wall_share` of what it
/// has, or by disc sector where nothing is wetted. Zero where there is neither.
inline std::array<double, 3> fluid_parts(const PoreNetwork& network, std::size_t throat,
                                         const std::array<Vertex, 3>& corners, const ThroatPlane& plane,
                                         double wall_share) {
  std::array<double, 3> wetted{};
  for (int c = 0; c < 3; ++c)
    wetted[c] = (is_wall(corners[c]) ? wall_share : 1) * network.throats.wetted_parts[throat][c];
  const auto sum = [](const std::array<double, 3>& of) { return of[0] + of[1] + of[2]; };
  const auto& by = sum(wetted) > 0 ? wetted : plane.sector;
  const double total = sum(by), scale = total > 0 ? plane.fluid_area / total : 0;
  return {scale * by[0], scale * by[1], scale * by[2]};
}

} // namespace pfv
