#include "pfv/flow/multigrid_level.hpp"

#include <algorithm>

namespace pfv {

template <class Value>
MultigridLevel::MultigridLevel(const MatrixView<Value>& matrix, double scale) {
  const auto rows = static_cast<std::size_t>(matrix.rows());
  const std::size_t above = (matrix.column.size() - std::min(rows, matrix.column.size())) / 2;
  start_.reserve(rows + 1);
  column_.reserve(above);
  value_.reserve(above);
  inverse_diagonal_.assign(rows, 0);
  start_.push_back(0);
  for (int i = 0; i < matrix.rows(); ++i) {
    for (int e = matrix.start[i]; e < matrix.start[i + 1]; ++e) {
      const auto value = static_cast<float>(scale * matrix.value[e]);
      if (matrix.column[e] == i && value > 0)
        inverse_diagonal_[i] = 1 / value;
      if (matrix.column[e] <= i)
        continue;
      column_.push_back(matrix.column[e]);
      value_.push_back(value);
    }
    start_.push_back(static_cast<int>(column_.size()));
  }
  right_side.assign(rows, 0);
  pressure.assign(rows, 0);
}

template MultigridLevel::MultigridLevel(const MatrixView<double>&, double);
template MultigridLevel::MultigridLevel(const MatrixView<float>&, double);

std::size_t MultigridLevel::memory_bytes() const {
  return sizeof(int) * (start_.size() + column_.size()) + sizeof(Parents) * from_coarser.size() +
         sizeof(float) * (value_.size() + inverse_diagonal_.size() + right_side.size() + pressure.size());
}

void MultigridLevel::sweep_up_from_zero() {
  for (int i = 0; i < rows(); ++i) {
    const float p = right_side[i] * inverse_diagonal_[i];
    pressure[i] = p;
    right_side[i] = 0; // from here on L p of the correction
    for (int e = start_[i]; e < start_[i + 1]; ++e)
      right_side[column_[e]] -= value_[e] * p;
  }
}

void MultigridLevel::restrict_residual_to(MultigridLevel& coarser) {
  std::ranges::fill(coarser.right_side, 0.0F);
  for (int i = 0; i < rows(); ++i) {
    float residual = 0;
    for (int e = start_[i]; e < start_[i + 1]; ++e)
      residual -= value_[e] * pressure[column_[e]];
    const Parents& parents = from_coarser[i];
    coarser.right_side[parents.row[0]] += parents.weight[0] * residual;
    coarser.right_side[parents.row[1]] += parents.weight[1] * residual;
  }
}

void MultigridLevel::add_correction_of(const MultigridLevel& coarser) {
  for (int i = 0; i < rows(); ++i) {
    const Parents& parents = from_coarser[i];
    const float correction =
        parents.weight[0] * coarser.pressure[parents.row[0]] + parents.weight[1] * coarser.pressure[parents.row[1]];
    for (int e = start_[i]; e < start_[i + 1]; ++e)
      right_side[column_[e]] += value_[e] * correction;
  }
}

void MultigridLevel::sweep_down() {
  for (int i = rows() - 1; i >= 0; --i) {
    float other = right_side[i];
    for (int e = start_[i]; e < start_[i + 1]; ++e)
      other += value_[e] * pressure[column_[e]];
    pressure[i] -= other * inverse_diagonal_[i];
  }
}

} // namespace pfv
