#pragma once

#include "pfv/solvers/interpolation.hpp"

#include <Eigen/Core>
#include <vector>

namespace pfv {

/// Pressures of one level of a multigrid, in single precision, and how they go to the next coarser one and back. A
/// V-cycle takes, in this order, a sweep up, a restriction, the correction of the coarser level and a sweep down; the
/// sweeps are those of a FinestLevel or of a CoarseLevel.
class MultigridLevel {
public:
  /// Without neighbours to take them from, all zero.
  explicit MultigridLevel(int rows);

  int rows() const { return static_cast<int>(pressure.size()); }
  std::size_t memory_bytes() const; // without the matrix

  /// right_side of the coarser level = P' right_side.
  void restrict_residual_to(MultigridLevel& coarser) const;
  /// The correction of p is P times the pressure of the coarser level.
  void take_correction_of(const MultigridLevel& coarser);
  void take_no_correction(); // where there is none

  Eigen::VectorXf right_side, pressure;
  const Eigen::VectorXf& inverse_diagonal() const { return inverse_diagonal_; }

  std::vector<Parents> from_coarser; // P, the interpolation from the coarser level; empty on the coarsest

protected:
  Eigen::VectorXf inverse_diagonal_, correction_;
};

} // namespace pfv
