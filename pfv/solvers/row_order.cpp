#include "pfv/solvers/row_order.hpp"

#include <algorithm>
#include <numeric>

namespace pfv {

void RowOrder::arrange_new_rows(SparseRows& matrix) {
  const int rows = matrix.rows() - done_, first = matrix.start[done_];
  column_.assign(matrix.column.begin() + first, matrix.column.end());
  value_.assign(matrix.value.begin() + first, matrix.value.end());
  start_.assign(matrix.start.begin() + done_, matrix.start.end());
  const auto length = [this](int row) { return start_[row + 1] - start_[row]; };
  next_.clear();
  for (int row = 0; row < rows; ++row) {
    next_.resize(std::max(next_.size(), static_cast<std::size_t>(length(row)) + 2));
    ++next_[length(row) + 1];
  }
  std::partial_sum(next_.begin(), next_.end(), next_.begin());
  row_.resize(static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) {
    const int place = next_[length(row)]++;
    place_[done_ + row] = done_ + place;
    row_[place] = row;
  }
  int end = first;
  for (const int row : row_) {
    std::copy_n(column_.begin() + (start_[row] - first), length(row), matrix.column.begin() + end);
    std::copy_n(value_.begin() + (start_[row] - first), length(row), matrix.value.begin() + end);
    end += length(row);
    matrix.start[++done_] = end;
  }
}

void RowOrder::finish(SparseRows& matrix, Interpolation& interpolation) {
  arrange_new_rows(matrix);
  for (int& column : matrix.column)
    column = place_[column];
  for (Parents& parents : interpolation.parents)
    for (int& row : parents.row)
      row = place_[row];
}

} // namespace pfv
