#pragma once

#include "pfv/solvers/interpolation.hpp"

#include <type_traits>
#include <vector>

namespace pfv {

/// Pressures and right side of one level of a multigrid, in single precision.
struct MultigridVectors {
  std::vector<float> right_side, pressure;
};

/// A p = b on one level of a multigrid. The matrix stays the caller's: the finest level, which holds most of all
/// entries, needs no copy. There all steps go along whole rows, most of which have the same length: no branch to guess.
/// On coarser levels rows are long, and the two steps that need but half of them take no more.
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

  /// (L + D) p = b, A = L + D + L': a sweep of Gauss-Seidel from p = 0 in ascending order.
  void sweep_up_from_zero();
  /// right_side of the coarser level = P' (b - A p).
  void restrict_residual_to(MultigridVectors& coarser) const;
  /// Adds P times the pressure of the coarser level to p.
  void add_correction_of(const MultigridVectors& coarser);
  /// A sweep of Gauss-Seidel in descending order.
  void sweep_down();

  std::vector<Parents> from_coarser; // P, the interpolation from the coarser level

private:
  static constexpr bool whole_rows = std::is_same_v<Value, double>;

  float sum(int first, int last) const;
  float residual(int row) const;

  MatrixView<Value> matrix_;
  Value scale_;
  std::vector<int> right_of_diagonal_;  // by row, the first entry there; empty when all steps go along whole rows
  std::vector<float> inverse_diagonal_; // 0 where the sum of a coarse diagonal has cancelled to nothing
};

} // namespace pfv
