#pragma once

#include "pfv/solvers/multigrid_level.hpp"

namespace pfv {

/// A p = b on a coarser level. Both sweeps go along whole rows.
class CoarseLevel : public MultigridLevel {
public:
  explicit CoarseLevel(SparseRows matrix);

  const SparseRows& matrix() const { return matrix_; }

  /// (L + D) p = b, A = L + D + L': a sweep of Gauss-Seidel from p = 0 in ascending order. Every row hands what it
  /// moves on to its neighbours, so that right_side is the residual b - A p when it ends.
  void sweep_up_from_zero();
  /// A sweep of Gauss-Seidel over the correction in descending order; adds it to p.
  void sweep_down();

private:
  SparseRows matrix_;
};

} // namespace pfv
