#pragma once

#include "pfv/solvers/interpolation.hpp"

#include <vector>

namespace pfv {

/// Pressures and right side of one level of a multigrid, in single precision.
struct MultigridVectors {
  std::vector<float> right_side, pressure;
};

/// A p = b on one level of a multigrid. The matrix stays the caller's: the finest level, which holds most of all
/// entries, needs no copy. All steps go along whole rows, though two halves would do for some: most rows of the finest
/// level have the same length, so that there is no branch to guess.
///
/// The four steps of a V-cycle, in this order:
template <class Value>
class MultigridLevel : public MultigridVectors {
public:
  /// A is `scale` times the matrix.
  MultigridLevel(const MatrixView<Value>& matrix, double scale);

  /// The same matrix, with new values.
  void follow(const MatrixView<Value>& matrix, double scale);

  int rows() const { return matrix_.rows(); }
  std::size_t memory_bytes() const; // without the matrix

  /// (L + D) p = b, A = L + D + L': a sweep of Gauss-Seidel from p = 0 in ascending order. Every row hands what it
  /// moves on to its neighbours, so that right_side is the residual b - A p when it ends.
  void sweep_up_from_zero();
  /// right_side of the coarser level = P' residual.
  void restrict_residual_to(MultigridVectors& coarser) const;
  /// The correction of p is P times the pressure of the coarser level.
  void take_correction_of(const MultigridVectors& coarser);
  void take_no_correction(); // where there is none
  /// A sweep of Gauss-Seidel over the correction in descending order; adds it to p.
  void sweep_down();

  std::vector<Parents> from_coarser; // P, the interpolation from the coarser level; empty on the coarsest

private:
  MatrixView<Value> matrix_;
  Value scale_;
  std::vector<float> inverse_diagonal_; // 0 where the sum of a coarse diagonal has cancelled to nothing
  std::vector<float> correction_;
};

} // namespace pfv
