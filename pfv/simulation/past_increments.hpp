#pragma once

#include <Eigen/Core>

namespace pfv {

/// The last few changes of a solution of K x = b from step to step, to guess the next one: of all combinations of them
/// the one with the least error in the norm of K (Fischer, Comput. Methods Appl. Mech. Eng. 163 (1998) 193). Pressures
/// move along few directions, but neither evenly nor without noise, so that no extrapolation of fixed weights does it.
class PastIncrements {
public:
  static constexpr int most = 4; // measured: 4 take a tenth more iterations, 16 save none

  /// Adds to the solution, and takes K times it from the residual, what the increments can do about the residual.
  void improve(Eigen::VectorXd& solution, Eigen::VectorXd& residual);
  /// Remembers an increment and K times it, in place of the oldest.
  void add(const Eigen::VectorXd& increment, const Eigen::VectorXd& image);
  void clear() { count_ = next_ = 0; }
  /// K has changed: `product(x, y)` is y = K x.
  template <class Product>
  void renew(const Product& product) {
    for (int i = 0; i < count_; ++i)
      product(increment_[i], image_[i]);
    for (int i = 0; i < count_; ++i)
      measure(i);
  }

private:
  void measure(int i);

  int count_ = 0, next_ = 0;
  Eigen::VectorXd increment_[most], image_[most];
  Eigen::Matrix<double, most, most> energy_; // increment . image
};

} // namespace pfv
