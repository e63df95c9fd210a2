#include "pfv/simulation/past_increments.hpp"

#include <Eigen/Cholesky>

namespace pfv {

void PastIncrements::improve(Eigen::VectorXd& solution, Eigen::VectorXd& residual) {
  using Small = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1>;
  if (count_ == 0)
    return;
  Small work(count_);
  for (int i = 0; i < count_; ++i)
    work[i] = increment_[i].dot(residual);
  const Small scale = energy_.diagonal().head(count_).cwiseSqrt().cwiseInverse();
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most, most> energy =
      scale.asDiagonal() * energy_.topLeftCorner(count_, count_) * scale.asDiagonal();
  energy.diagonal().array() += 1e-13; // increments along the same line leave nothing of one another
  const Small share = scale.cwiseProduct(energy.llt().solve(scale.cwiseProduct(work)).eval());
  if (!share.allFinite())
    return;
  for (int i = 0; i < count_; ++i) {
    solution += share[i] * increment_[i];
    residual -= share[i] * image_[i];
  }
}

void PastIncrements::add(const Eigen::VectorXd& increment, const Eigen::VectorXd& image) {
  if (!(increment.dot(image) > 0))
    return;
  increment_[next_] = increment;
  image_[next_] = image;
  count_ = std::max(count_, next_ + 1);
  measure(next_);
  next_ = (next_ + 1) % most;
}

void PastIncrements::measure(int i) {
  for (int j = 0; j < count_; ++j)
    energy_(i, j) = energy_(j, i) = increment_[i].dot(image_[j]);
}

} // namespace pfv
