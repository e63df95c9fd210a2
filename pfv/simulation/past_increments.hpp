#pragma once

#include <Eigen/Core>

#include <array>

namespace pfv {

/// The last few changes of a solution of K x = b from step to step, to guess the next one: of all combinations of them
/// the one with the least error in the norm of K (Fischer, Comput. Methods Appl. Mech. Eng. 163 (1998) 193). Pressures
/// move along few directions, but neither evenly nor without noise, so that no extrapolation of fixed weights does it.
class PastIncrements {
public:
  /// From the last solution, with its residual b - K x, to the guess: adds what the increments can do.
  void improve(Eigen::VectorXd& solution, Eigen::VectorXd& residual);
  /// Remembers what has become of them, in place of the oldest increment. One whose square in the norm of K is
  /// negligible is forgotten: its image, a difference of two residuals, is round-off where K is stiff.
  void remember(const Eigen::VectorXd& solution, const Eigen::VectorXd& residual, double negligible);
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
  static constexpr int most = 4; // measured: 8 save a twentieth of the iterations and cost as much
  void measure(int i);

  int count_ = 0, next_ = 0;
  std::array<Eigen::VectorXd, most> increment_, image_; // K times it
  Eigen::Matrix<double, most, most> energy_;            // increment . image
  Eigen::VectorXd start_, start_residual_;
};

} // namespace pfv
