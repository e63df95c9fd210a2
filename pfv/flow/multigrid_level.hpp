#pragma once

#include "pfv/flow/interpolation.hpp"

namespace pfv {

/// A p = b on one level of a multigrid, in single precision. A = L + D + L' is kept by its diagonal and the rows of L',
/// which serve L too when they are scattered: half the memory, in the same time.
///
/// The four steps of a V-cycle, in this order. They leave the right side used up:
class MultigridLevel {
public:
  /// A is `scale` times the matrix.
  template <class Value>
  MultigridLevel(const MatrixView<Value>& matrix, double scale);

  int rows() const { return static_cast<int>(pressure.size()); }
  std::size_t entries() const { return 2 * column_.size() + pressure.size(); }
  std::size_t memory_bytes() const;

  /// (L + D) p = b: a sweep of Gauss-Seidel from p = 0 in ascending order.
  void sweep_up_from_zero();
  /// right_side of the coarser level = P' (b - A p), which is - P' L' p after the sweep.
  void restrict_residual_to(MultigridLevel& coarser);
  /// Adds P times the pressure of the coarser level to p, as far as the sweep down will see of it: L P p.
  void add_correction_of(const MultigridLevel& coarser);
  /// A sweep of Gauss-Seidel in descending order, (D + L') p_new = b - L p, in which b - L p = D p of the sweep up less
  /// what the correction has added.
  void sweep_down();

  std::vector<float> right_side, pressure;
  std::vector<Parents> from_coarser; // P, the interpolation from the coarser level

private:
  std::vector<int> start_, column_; // of L'
  std::vector<float> value_;
  std::vector<float> inverse_diagonal_; // 0 where the sum of a coarse diagonal has cancelled to nothing
};

} // namespace pfv
