#pragma once

#include "reference/stokes_fem/stokes_ranks/petsc.hpp"
#include "reference/stokes_fem/stokes_ranks/rank_system.hpp"

namespace reference::stokes_fem {

/// diag(A^-1, S^-1) for Stokes' equations, symmetric and positive: A^-1 a cycle of BoomerAMG on the velocities, S^-1 =
/// L^-1 (B D^-1 A D^-1 B^T) L^-1 as CommutatorPreconditioner of the solver for one process has it, L^-1 a cycle again.
/// Keeps a reference to the system.
class BlockPreconditioner {
public:
  /// Throws std::runtime_error when PETSc or hypre fail.
  explicit BlockPreconditioner(const RankSystem& system);

  void velocity(Vec residual, Vec correction) const;
  void pressure(Vec residual, Vec correction) const;

private:
  void make_laplace();

  const RankSystem& system_;
  OwnedVec inverse_diagonal_;
  OwnedMat laplace_;
  OwnedPc velocity_cycle_;
  OwnedPc pressure_cycle_;
  OwnedVec inner_;
  OwnedVec middle_;
  OwnedVec gradient_;
  OwnedVec applied_;
};

} // namespace reference::stokes_fem
