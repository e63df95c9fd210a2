#pragma once

#include <numeric>
#include <vector>

namespace pfv {

/// Disjoint sets of pores (union-find with path halving).
class PoreGroups {
public:
  explicit PoreGroups(std::size_t pores) : parent_(pores) { std::iota(parent_.begin(), parent_.end(), 0); }

  int find(int pore) {
    while (parent_[pore] != pore)
      pore = parent_[pore] = parent_[parent_[pore]];
    return pore;
  }

  void join(int a, int b) { parent_[find(a)] = find(b); }

private:
  std::vector<int> parent_;
};

} // namespace pfv
