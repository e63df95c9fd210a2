#include "pfv/solvers/short_rows.hpp"

#include <array>

namespace pfv {

void ShortRows::take(const MatrixView<double>& matrix, double scale, Eigen::VectorXf& diagonal, Eigen::VectorXf& sum) {
  diagonal.resize(matrix.rows());
  sum.resize(matrix.rows());
  columns_.resize(places * static_cast<std::size_t>(matrix.rows()));
  values_.resize(columns_.size());
  long_row_.clear();
  long_.start.resize(1);
  long_.column.clear();
  long_.value.clear();
  std::array<int, places + 1> columns{};
  std::array<float, places + 1> values{};
  for (int i = 0; i < matrix.rows(); ++i) {
    const int first = matrix.start[i], last = matrix.start[i + 1];
    const bool is_short = static_cast<std::size_t>(last - first) <= places + 1;
    std::size_t count = 0;
    int at_diagonal = first; // counted, without a branch to guess
    double row_sum = 0;
    for (int e = first; e < last; ++e) {
      const int column = matrix.column[e];
      const auto value = static_cast<float>(scale * matrix.value[e]);
      at_diagonal += column < i ? 1 : 0;
      row_sum += matrix.value[e];
      if (is_short) {
        columns[count] = column;
        values[count] = value;
        count += column != i ? 1 : 0;
      } else if (column != i) {
        long_.column.push_back(column);
        long_.value.push_back(value);
      }
    }
    for (std::size_t k = 0; k < places; ++k) {
      columns_[places * i + k] = k < count ? columns[k] : i;
      values_[places * i + k] = k < count ? values[k] : 0;
    }
    if (!is_short) {
      long_.start.push_back(static_cast<int>(long_.column.size()));
      long_row_.push_back(i);
    }
    const bool has_diagonal = at_diagonal < last && matrix.column[at_diagonal] == i;
    diagonal[i] = has_diagonal ? static_cast<float>(scale * matrix.value[at_diagonal]) : 0;
    sum[i] = static_cast<float>(scale * row_sum);
  }
}

std::size_t ShortRows::memory_bytes() const {
  return sizeof(int) * (columns_.size() + long_row_.size()) + sizeof(float) * values_.size() + long_.memory_bytes();
}

} // namespace pfv
