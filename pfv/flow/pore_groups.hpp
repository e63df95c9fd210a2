#pragma once

#include "pfv/pores/sites.hpp"

#include <cstddef>
#include <numeric>
#include <vector>

namespace pfv {

/// Disjoint sets of pores (union-find with path halving; Tarjan & van Leeuwen, J. ACM 31 (1984) 245). In a periodic box
/// a set also knows by how many boxes each pore is off: pore i moved by offset(i) is beside pore find(i).
class PoreGroups {
public:
  PoreGroups(std::size_t pores, bool periodic) : parent_(pores), offset_(periodic ? pores : 0) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int find(int pore) {
    while (parent_[pore] != pore)
      pore = halve(pore);
    return pore;
  }

  /// Nothing unless the box is periodic.
  Shift offset(int pore) {
    if (offset_.empty())
      return {};
    for (int root = find(pore); parent_[pore] != root;)
      halve(pore);
    return offset_[pore];
  }

  /// Pore a is beside pore b moved by `shift`.
  void join(int a, int b, const Shift& shift) {
    const int root = find(a), other = find(b);
    if (root == other)
      return;
    const int first = root < other ? root : other, second = root < other ? other : root; // so that paths stay short
    if (!offset_.empty())
      offset_[second] = second == root ? offset(b) - offset(a) - shift : offset(a) + shift - offset(b);
    parent_[second] = first;
  }

private:
  int halve(int pore) {
    const int above = parent_[pore];
    if (!offset_.empty() && parent_[above] != above)
      offset_[pore] = offset_[pore] + offset_[above];
    return parent_[pore] = parent_[above];
  }

  std::vector<int> parent_;
  std::vector<Shift> offset_; // to the parent
};

} // namespace pfv
