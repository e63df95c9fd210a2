#include "pfv/solvers/multigrid_level.hpp"

#include <algorithm>

namespace pfv {

template <class Value>
MultigridLevel<Value>::MultigridLevel(const MatrixView<Value>& matrix, double scale) {
  const auto rows = static_cast<std::size_t>(matrix.rows());
  for (std::vector<float>* vector : {&right_side, &pressure, &inverse_diagonal_, &correction_})
    vector->assign(rows, 0);
  follow(matrix, scale);
}

template <class Value>
void MultigridLevel<Value>::follow(const MatrixView<Value>& matrix, double scale) {
  matrix_ = matrix;
  scale_ = static_cast<Value>(scale);
  for (int i = 0; i < matrix.rows(); ++i) {
    const int last = matrix.start[i + 1];
    int diagonal = matrix.start[i];
    for (int e = diagonal; e < last; ++e) // to the end: no branch to guess
      diagonal += matrix.column[e] < i ? 1 : 0;
    const bool is_solved = diagonal < last && matrix.column[diagonal] == i && matrix.value[diagonal] > 0;
    inverse_diagonal_[i] = is_solved ? static_cast<float>(1 / (scale_ * matrix.value[diagonal])) : 0;
  }
}

template <class Value>
std::size_t MultigridLevel<Value>::memory_bytes() const {
  return sizeof(Parents) * from_coarser.size() +
         sizeof(float) * (inverse_diagonal_.size() + right_side.size() + pressure.size() + correction_.size());
}

template <class Value>
void MultigridLevel<Value>::sweep_up_from_zero() {
  const Value scale = scale_; // nothing that is written here
  for (int i = 0; i < rows(); ++i) {
    const float p = right_side[i] * inverse_diagonal_[i];
    pressure[i] = p;
    for (int e = matrix_.start[i]; e < matrix_.start[i + 1]; ++e)
      right_side[matrix_.column[e]] -= static_cast<float>(scale * matrix_.value[e]) * p;
  }
}

template <class Value>
void MultigridLevel<Value>::restrict_residual_to(MultigridVectors& coarser) const {
  std::ranges::fill(coarser.right_side, 0.0F);
  for (int i = 0; i < rows(); ++i) {
    const Parents& parents = from_coarser[i];
    coarser.right_side[parents.row[0]] += parents.weight[0] * right_side[i];
    coarser.right_side[parents.row[1]] += parents.weight[1] * right_side[i];
  }
}

template <class Value>
void MultigridLevel<Value>::take_correction_of(const MultigridVectors& coarser) {
  for (int i = 0; i < rows(); ++i) {
    const Parents& parents = from_coarser[i];
    correction_[i] =
        parents.weight[0] * coarser.pressure[parents.row[0]] + parents.weight[1] * coarser.pressure[parents.row[1]];
  }
}

template <class Value>
void MultigridLevel<Value>::take_no_correction() {
  std::ranges::fill(correction_, 0.0F);
}

template <class Value>
void MultigridLevel<Value>::sweep_down() {
  const Value scale = scale_;
  for (int i = rows() - 1; i >= 0; --i) {
    Value image = 0;
    for (int e = matrix_.start[i]; e < matrix_.start[i + 1]; ++e)
      image += matrix_.value[e] * static_cast<Value>(correction_[matrix_.column[e]]);
    const float correction =
        correction_[i] + (right_side[i] - static_cast<float>(scale * image)) * inverse_diagonal_[i];
    correction_[i] = correction;
    pressure[i] += correction;
  }
}

template class MultigridLevel<double>;
template class MultigridLevel<float>;

} // namespace pfv
