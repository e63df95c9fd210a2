#pragma once

#include "pfv/solvers/multigrid_level.hpp"
#include "pfv/solvers/short_rows.hpp"

namespace pfv {

/// A p = b on the finest level, which takes most of the time.
class FinestLevel : public MultigridLevel {
public:
  /// A is `scale` times the matrix, rounded to single precision. Throws SolveError when its diagonal is not positive.
  FinestLevel(const MatrixView<double>& matrix, double scale);

  /// The same pattern with new values.
  void follow(const MatrixView<double>& matrix, double scale);

  std::size_t memory_bytes() const {
    return MultigridLevel::memory_bytes() + matrix_.memory_bytes() + sizeof(float) * static_cast<std::size_t>(rows());
  }

  const ShortRows& matrix() const { return matrix_; }

  /// As those of a CoarseLevel.
  void sweep_up_from_zero();
  void sweep_down();

  /// product() = A x, until the next V-cycle, which needs the room; returns x.A x.
  double multiply(const Eigen::VectorXf& x);
  const Eigen::VectorXf& product() const { return correction_; }

private:
  ShortRows matrix_;
  Eigen::VectorXf row_sum_;
};

} // namespace pfv
