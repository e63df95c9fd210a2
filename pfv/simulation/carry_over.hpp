#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace pfv {

/// Pressures (Pa) of the pores of a new triangulation from those of an old one: that of the pore between the same four
/// bodies, or where there was none the mean over its bodies of the mean pressure around each.
std::vector<double> carried_over(const std::vector<std::array<int, 4>>& old_bodies, const std::vector<double>& pressure,
                                 const std::vector<std::array<int, 4>>& new_bodies, std::size_t bodies);

} // namespace pfv
