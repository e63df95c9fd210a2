#pragma once

#include "pfv/solvers/sparse_rows.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace pfv {

/// The entries beside the diagonal of a matrix of which nearly every row has at most four, as a pore has four
/// neighbours; in single precision. A row has four places, of which the ones left over hold zeros in its own column: no
/// loop has an end to guess. Longer rows, of merged pores, are kept apart.
class ShortRows {
public:
  /// `scale` times the matrix, whose rows ascend, and by row its diagonal and the sum of all entries, which is summed
  /// in double precision as next to nothing is left of it. No allocation when it has the pattern of the last one.
  void take(const MatrixView<double>& matrix, double scale, Eigen::VectorXf& diagonal, Eigen::VectorXf& sum);

  int rows() const { return static_cast<int>(columns_.size() / places); }
  std::size_t memory_bytes() const;

  /// visit(row, columns, values) for every row.
  template <class Visit>
  void ascending(Visit visit) const {
    int row = 0;
    for (std::size_t k = 0; k < long_row_.size(); ++k) {
      for (; row < long_row_[k]; ++row)
        visit(row, four(columns_, row), four(values_, row));
      visit(row++, part(long_.column, k), part(long_.value, k));
    }
    for (; row < rows(); ++row)
      visit(row, four(columns_, row), four(values_, row));
  }
  template <class Visit>
  void descending(Visit visit) const {
    int row = rows() - 1;
    for (std::size_t k = long_row_.size(); k-- > 0;) {
      for (; row > long_row_[k]; --row)
        visit(row, four(columns_, row), four(values_, row));
      visit(row--, part(long_.column, k), part(long_.value, k));
    }
    for (; row >= 0; --row)
      visit(row, four(columns_, row), four(values_, row));
  }

private:
  static constexpr std::size_t places = 4;

  template <class T>
  static std::span<const T, places> four(const std::vector<T>& values, int row) {
    return std::span<const T, places>(values.data() + places * static_cast<std::size_t>(row), places);
  }
  template <class T>
  std::span<const T> part(const std::vector<T>& values, std::size_t k) const {
    return std::span(values).subspan(long_.start[k], long_.start[k + 1] - long_.start[k]);
  }

  std::vector<int> columns_;  // places by row
  std::vector<float> values_; // alike
  std::vector<int> long_row_; // ascending
  SparseRows long_;           // theirs
};

} // namespace pfv
