#include "pfv/flow/multigrid_level.hpp"

#include <algorithm>

namespace pfv {

MultigridLevel::MultigridLevel(const FlowMatrix& matrix, double scale) {
  const auto whole = view(matrix);
  start_ = whole.start;
  column_ = whole.column;
  value_.resize(whole.value.size());
  std::ranges::transform(whole.value, value_.begin(), [scale](double v) { return static_cast<float>(scale * v); });
  invert_diagonal();
}

MultigridLevel::MultigridLevel(SparseRows matrix) : own_(std::move(matrix)) {
  start_ = own_.start;
  column_ = own_.column;
  value_ = std::move(own_.value);
  invert_diagonal();
}

void MultigridLevel::invert_diagonal() {
  const std::size_t rows = start_.size() - 1;
  right_side.assign(rows, 0);
  pressure.assign(rows, 0);
  inverse_diagonal_.assign(rows, 0); // stays 0 where the sum of a coarse diagonal has cancelled to nothing
  for (int i = 0; i < this->rows(); ++i)
    for (int e = start_[i]; e < start_[i + 1]; ++e)
      if (column_[e] == i && value_[e] > 0)
        inverse_diagonal_[i] = 1 / value_[e];
}

std::size_t MultigridLevel::memory_bytes() const {
  return own_.memory_bytes() + sizeof(Parents) * from_coarser.size() +
         sizeof(float) * (value_.size() + inverse_diagonal_.size() + right_side.size() + pressure.size());
}

void MultigridLevel::sweep_up_from_zero() {
  for (int i = 0; i < rows(); ++i) {
    float balance = right_side[i];
    for (int e = start_[i]; column_[e] < i; ++e)
      balance -= value_[e] * pressure[column_[e]];
    pressure[i] = balance * inverse_diagonal_[i];
  }
}

void MultigridLevel::restrict_residual_to(MultigridLevel& coarser) const {
  std::ranges::fill(coarser.right_side, 0.0F);
  for (int i = 0; i < rows(); ++i) {
    float residual = right_side[i];
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
    pressure[i] +=
        parents.weight[0] * coarser.pressure[parents.row[0]] + parents.weight[1] * coarser.pressure[parents.row[1]];
  }
}

void MultigridLevel::sweep_down() {
  for (int i = rows() - 1; i >= 0; --i) {
    float balance = right_side[i];
    for (int e = start_[i]; e < start_[i + 1]; ++e)
      balance -= value_[e] * pressure[column_[e]];
    pressure[i] += balance * inverse_diagonal_[i];
  }
}

} // namespace pfv
