#include "pfv/simulation/past_increments.hpp"

#include <Eigen/Cholesky>

#include <algorithm>

namespace pfv {
namespace {

/// Of the solution: the image of a smaller increment, a difference of two residuals, is known to less than eight
/// digits.
constexpr double least_share = 1e-8;

} // namespace

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
  energy.diagonal().array() += 1e-13; // increments along the same line leave nothing of one another
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

void PastIncrements::remember(const Eigen::VectorXd& solution, const Eigen::VectorXd& residual) {
  increment_[next_] = solution - start_;
  image_[next_] = start_residual_ - residual;
  const bool noise = increment_[next_].squaredNorm() <= least_share * least_share * solution.squaredNorm();
  if (noise || !(increment_[next_].dot(image_[next_]) > 0)) {
    count_ = std::min(count_, next_); // nothing has changed, or not by a solution
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
