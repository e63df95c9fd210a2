#include "pfv/simulation/past_increments.hpp"

#include <Eigen/Cholesky>

#include <algorithm>

namespace pfv {

void PastIncrements::improve(Eigen::VectorXd& solution, Eigen::VectorXd& residual) {
  start_ = solution;
  start_residual_ = residual;
  if (count_ == 0)
    return;
  using Small = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1>;
  using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most, most>;
  const Small scale = energy_.diagonal().head(count_).cwiseSqrt().cwiseInverse();
  Small work(count_);
  for (int i = 0; i < count_; ++i)
    work[i] = scale[i] * increment_[i].dot(residual);
  SmallMatrix energy = scale.asDiagonal() * energy_.topLeftCorner(count_, count_) * scale.asDiagonal();
  energy.diagonal().array() += 1e-8; // of increments along one line little but round-off is left
  const Eigen::LLT<SmallMatrix> factor(energy);
  if (factor.info() != Eigen::Success) // round-off: they say nothing
    return;
  const Small share = factor.solve(work);
  if (!share.allFinite())
    return;
  for (int i = 0; i < count_; ++i) {
    solution += share[i] * scale[i] * increment_[i];
    residual -= share[i] * scale[i] * image_[i];
  }
}

void PastIncrements::remember(const Eigen::VectorXd& solution, const Eigen::VectorXd& residual, double negligible) {
  increment_[next_] = solution - start_;
  image_[next_] = start_residual_ - residual;
  if (!(increment_[next_].dot(image_[next_]) > negligible)) {
    count_ = std::min(count_, next_);
    return;
  }
  count_ = std::max(count_, next_ + 1);
  measure(next_);
  next_ = (next_ + 1) % most;
}

void PastIncrements::measure(int i) {
  for (int j = 0; j < count_; ++j)
    energy_(i, j) = energy_(j, i) = increment_[i].dot(image_[j]);
}

} // namespace pfv
