#pragma once

#include "pfv/flow/interpolation.hpp"

namespace pfv {

/// A p = b on one level of a multigrid, in single precision.
class MultigridLevel {
public:
  /// Takes the pattern from the matrix, which must outlive the level, and its values times `scale`.
  MultigridLevel(const FlowMatrix& matrix, double scale);
  explicit MultigridLevel(SparseRows matrix);

  int rows() const { return static_cast<int>(pressure.size()); }
  std::size_t entries() const { return column_.size(); }
  MatrixView<float> matrix() const { return {start_, column_, value_}; }
  std::size_t memory_bytes() const;

  /// A sweep of Gauss-Seidel from p = 0, in ascending order.
  void sweep_up_from_zero();
  /// right_side of the coarser level = P' (b - A p).
  void restrict_residual_to(MultigridLevel& coarser) const;
  /// p += P pressure of the coarser level.
  void add_correction_of(const MultigridLevel& coarser);
  /// A sweep of Gauss-Seidel in descending order.
  void sweep_down();

  std::vector<float> right_side, pressure;
  std::vector<Parents> from_coarser; // P, the interpolation from the coarser level

private:
  void invert_diagonal();

  SparseRows own_;
  std::span<const int> start_, column_;
  std::vector<float> value_;
  std::vector<float> inverse_diagonal_;
};

} // namespace pfv
