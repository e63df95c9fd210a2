#include "pfv/solvers/multigrid_level.hpp"

#include <algorithm>

namespace pfv {

template <class Value>
MultigridLevel<Value>::MultigridLevel(const MatrixView<Value>& matrix, double scale) {
  const auto rows = static_cast<std::size_t>(matrix.rows());
  right_side.assign(rows, 0);
  pressure.assign(rows, 0);
  inverse_diagonal_.resize(rows);
  if (!whole_rows)
    right_of_diagonal_.resize(rows);
  follow(matrix, scale);
}

template <class Value>
void MultigridLevel<Value>::follow(const MatrixView<Value>& matrix, double scale) {
  matrix_ = matrix;
  scale_ = static_cast<Value>(scale);
  for (int i = 0; i < matrix.rows(); ++i) {
    const int last = matrix.start[i + 1];
    int right = matrix.start[i];
    for (int e = right; e < last; ++e) // to the end: no branch to guess
      right += matrix.column[e] < i ? 1 : 0;
    inverse_diagonal_[i] = 0;
    if (right < last && matrix.column[right] == i) {
      if (matrix.value[right] > 0)
        inverse_diagonal_[i] = static_cast<float>(1 / (scale_ * matrix.value[right]));
      ++right;
    }
    if (!whole_rows)
      right_of_diagonal_[i] = right;
  }
}

template <class Value>
std::size_t MultigridLevel<Value>::memory_bytes() const {
  return sizeof(Parents) * from_coarser.size() +
         sizeof(float) * (inverse_diagonal_.size() + right_side.size() + pressure.size()) +
         sizeof(int) * right_of_diagonal_.size();
}

template <class Value>
inline float MultigridLevel<Value>::sum(int first, int last) const {
  Value result = 0;
  for (int e = first; e < last; ++e)
    result += matrix_.value[e] * static_cast<Value>(pressure[matrix_.column[e]]);
  return static_cast<float>(scale_ * result);
}

template <class Value>
inline float MultigridLevel<Value>::residual(int row) const {
  return right_side[row] - sum(matrix_.start[row], matrix_.start[row + 1]);
}

template <class Value>
void MultigridLevel<Value>::sweep_up_from_zero() {
  std::ranges::fill(pressure, 0.0F);
  for (int i = 0; i < rows(); ++i) {
    const int last = whole_rows ? matrix_.start[i + 1] : right_of_diagonal_[i];
    pressure[i] = (right_side[i] - sum(matrix_.start[i], last)) * inverse_diagonal_[i];
  }
}

template <class Value>
void MultigridLevel<Value>::restrict_residual_to(MultigridVectors& coarser) const {
  std::ranges::fill(coarser.right_side, 0.0F);
  for (int i = 0; i < rows(); ++i) {
    const bool is_solved = !whole_rows && inverse_diagonal_[i] > 0; // but for what came after it
    const float rest = is_solved ? -sum(right_of_diagonal_[i], matrix_.start[i + 1]) : residual(i);
    const Parents& parents = from_coarser[i];
    coarser.right_side[parents.row[0]] += parents.weight[0] * rest;
    coarser.right_side[parents.row[1]] += parents.weight[1] * rest;
  }
}

template <class Value>
void MultigridLevel<Value>::add_correction_of(const MultigridVectors& coarser) {
  for (int i = 0; i < rows(); ++i) {
    const Parents& parents = from_coarser[i];
    pressure[i] +=
        parents.weight[0] * coarser.pressure[parents.row[0]] + parents.weight[1] * coarser.pressure[parents.row[1]];
  }
}

template <class Value>
void MultigridLevel<Value>::sweep_down() {
  for (int i = rows() - 1; i >= 0; --i)
    pressure[i] += residual(i) * inverse_diagonal_[i];
}

template class MultigridLevel<double>;
template class MultigridLevel<float>;

} // namespace pfv
