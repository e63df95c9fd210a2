#include "pfv/solvers/coarse_level.hpp"

#include <utility>

namespace pfv {

CoarseLevel::CoarseLevel(SparseRows matrix) : MultigridLevel(matrix.rows()), matrix_(std::move(matrix)) {
  for (int i = 0; i < rows(); ++i) {
    float diagonal = 0;
    for (int e = matrix_.start[i]; e < matrix_.start[i + 1]; ++e) // no branch to guess
      diagonal += matrix_.column[e] == i ? matrix_.value[e] : 0;
    inverse_diagonal_[i] = diagonal > 0 ? 1 / diagonal : 0; // else the sum has cancelled to nothing
  }
}

void CoarseLevel::sweep_up_from_zero() {
  for (int i = 0; i < rows(); ++i) {
    const float p = right_side[i] * inverse_diagonal_[i];
    pressure[i] = p;
    for (int e = matrix_.start[i]; e < matrix_.start[i + 1]; ++e)
      right_side[matrix_.column[e]] -= matrix_.value[e] * p;
  }
}

void CoarseLevel::sweep_down() {
  for (int i = rows() - 1; i >= 0; --i) {
    float image = 0;
    for (int e = matrix_.start[i]; e < matrix_.start[i + 1]; ++e)
      image += matrix_.value[e] * correction_[matrix_.column[e]];
    const float correction = correction_[i] + (right_side[i] - image) * inverse_diagonal_[i];
    correction_[i] = correction;
    pressure[i] += correction;
  }
}

} // namespace pfv
