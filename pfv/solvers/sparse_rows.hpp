#pragma once

#include "pfv/solvers/flow_matrix.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace pfv {

/// Rows of (column, value) in flat arrays: row i is entries start[i] .. start[i + 1].
struct SparseRows {
  std::vector<int> start = {0};
  std::vector<int> column;
  std::vector<float> value;

  int rows() const { return static_cast<int>(start.size()) - 1; }
  /// visit(row, columns, values) for every row.
  template <class Visit>
  void ascending(Visit visit) const {
    for (int row = 0; row < rows(); ++row) {
      const auto first = static_cast<std::size_t>(start[row]), count = static_cast<std::size_t>(start[row + 1]) - first;
      visit(row, std::span(column.data() + first, count), std::span(value.data() + first, count));
    }
  }
  std::size_t memory_bytes() const {
    return sizeof(int) * (start.size() + column.size()) + sizeof(float) * value.size();
  }
};

/// A matrix by rows: entries start[i] .. start[i + 1], in any order.
template <class Value>
struct MatrixView {
  std::span<const int> start, column;
  std::span<const Value> value;

  int rows() const { return static_cast<int>(start.size()) - 1; }
};

inline MatrixView<float> view(const SparseRows& matrix) {
  return {matrix.start, matrix.column, matrix.value};
}

inline MatrixView<double> view(const FlowMatrix& matrix) {
  const auto rows = static_cast<std::size_t>(matrix.rows()), entries = static_cast<std::size_t>(matrix.nonZeros());
  return {{matrix.outerIndexPtr(), rows + 1}, {matrix.innerIndexPtr(), entries}, {matrix.valuePtr(), entries}};
}

} // namespace pfv
