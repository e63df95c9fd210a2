#pragma once

#include "pfv/solvers/interpolation.hpp"

#include <vector>

namespace pfv {

/// Puts rows of one length next to each other, 64 at a time: they stay near in memory, and where a row ends is no
/// surprise to loops over them, which take a third less time.
class RowOrder {
public:
  explicit RowOrder(int rows) : place_(static_cast<std::size_t>(rows)) {}

  /// After each row that the matrix has got: arranges the last 64 once they are complete.
  void follow(SparseRows& matrix) {
    if (matrix.rows() - done_ == together)
      arrange_new_rows(matrix);
  }
  /// After the last one: arranges those that are left, and numbers columns and parents as the rows are now.
  void finish(SparseRows& matrix, Interpolation& interpolation);

private:
  static constexpr int together = 64;

  void arrange_new_rows(SparseRows& matrix);

  int done_ = 0;
  std::vector<int> place_; // by row as it came
  // Of the rows that are arranged: by place, where the next one of a length goes, and what they were.
  std::vector<int> row_, next_, start_, column_;
  std::vector<float> value_;
};

} // namespace pfv
