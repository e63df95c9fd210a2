#pragma once

#include <Eigen/Core>

#include <vector>

namespace reference::stokes_fem {

/// One column per node: three velocity components and an unused lane, so that a column fills vector registers.
template <class T>
using Lanes = Eigen::Array<T, 4, Eigen::Dynamic>;

/// Sparse symmetric matrix over nodes, one for all lanes: row i has entries start[i] ... start[i + 1] - 1, columns
/// ascending. What a lane holds at zero is in the mask that products are multiplied with.
struct NodePattern {
  std::vector<int> start{0};
  std::vector<int> column;

  int rows() const { return static_cast<int>(start.size()) - 1; }
};

/// Right side less the row's product.
template <class T>
Eigen::Array<T, 4, 1> row_residual(const NodePattern& pattern, const std::vector<T>& values, const Lanes<T>& right_side,
                                   const Lanes<T>& x, int row) {
  Eigen::Array<T, 4, 1> sum = right_side.col(row);
  for (int entry = pattern.start[static_cast<std::size_t>(row)];
       entry < pattern.start[static_cast<std::size_t>(row) + 1]; ++entry)
    sum -= values[static_cast<std::size_t>(entry)] * x.col(pattern.column[static_cast<std::size_t>(entry)]);
  return sum;
}

} // namespace reference::stokes_fem
