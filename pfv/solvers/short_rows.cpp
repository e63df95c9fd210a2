#include "pfv/solvers/short_rows.hpp"

namespace pfv {

void ShortRows::take(const MatrixView<double>& matrix, double scale) {
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
    std::size_t count = 0;
    if (static_cast<std::size_t>(last - first) <= places + 1)
      for (int e = first; e < last; ++e) {
        columns[count] = matrix.column[e];
        values[count] = static_cast<float>(scale * matrix.value[e]);
        count += matrix.column[e] != i ? 1 : 0;
      }
    else {
      for (int e = first; e < last; ++e)
        if (matrix.column[e] != i) {
          long_.column.push_back(matrix.column[e]);
          long_.value.push_back(static_cast<float>(scale * matrix.value[e]));
        }
      long_.start.push_back(static_cast<int>(long_.column.size()));
      long_row_.push_back(i);
    }
    for (std::size_t k = 0; k < places; ++k) {
      columns_[places * i + k] = k < count ? columns[k] : i;
      values_[places * i + k] = k < count ? values[k] : 0;
    }
  }
}

std::size_t ShortRows::memory_bytes() const {
  return sizeof(int) * (columns_.size() + long_row_.size()) + sizeof(float) * values_.size() + long_.memory_bytes();
}

} // namespace pfv
