#include "pfv/solvers/multigrid_level.hpp"

namespace pfv {

MultigridLevel::MultigridLevel(int rows) {
  for (Eigen::VectorXf* vector : {&right_side, &pressure, &inverse_diagonal_, &correction_})
    vector->setZero(rows);
}

std::size_t MultigridLevel::memory_bytes() const {
  return sizeof(Parents) * from_coarser.size() + 4 * sizeof(float) * static_cast<std::size_t>(rows());
}

void MultigridLevel::restrict_residual_to(MultigridLevel& coarser) const {
  coarser.right_side.setZero();
  for (int i = 0; i < rows(); ++i) {
    const Parents& parents = from_coarser[i];
    coarser.right_side[parents.row[0]] += parents.weight[0] * right_side[i];
    coarser.right_side[parents.row[1]] += parents.weight[1] * right_side[i];
  }
}

void MultigridLevel::take_correction_of(const MultigridLevel& coarser) {
  for (int i = 0; i < rows(); ++i) {
    const Parents& parents = from_coarser[i];
    correction_[i] =
        parents.weight[0] * coarser.pressure[parents.row[0]] + parents.weight[1] * coarser.pressure[parents.row[1]];
  }
}

void MultigridLevel::take_no_correction() {
  correction_.setZero();
}

} // namespace pfv
