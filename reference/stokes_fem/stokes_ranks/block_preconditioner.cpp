#include "reference/stokes_fem/stokes_ranks/block_preconditioner.hpp"

namespace reference::stokes_fem {

BlockPreconditioner::BlockPreconditioner(const RankSystem& system) : system_(system) {
  const Mat laplacian = system.laplacian;
  const MPI_Comm ranks = system.laplacian.get_mpi_communicator();
  check(MatCreateVecs(laplacian, inverse_diagonal_.fresh(), gradient_.fresh()));
  check(VecDuplicate(gradient_, applied_.fresh()));
  check(MatGetDiagonal(laplacian, inverse_diagonal_));
  check(VecReciprocal(inverse_diagonal_));
  make_laplace();
  check(MatCreateVecs(laplace_, inner_.fresh(), middle_.fresh()));

  check(PCCreate(ranks, multigrid_.fresh()));
  check(PCSetOptionsPrefix(multigrid_, "velocity_"));
  check(PCSetOperators(multigrid_, laplacian, laplacian));
  check(PCSetType(multigrid_, PCHYPRE));
  check(PCHYPRESetType(multigrid_, "boomeramg"));
  check(PCSetFromOptions(multigrid_));
  check(PCSetUp(multigrid_));

  check(PCCreate(ranks, factor_.fresh()));
  check(PCSetOptionsPrefix(factor_, "pressure_"));
  check(PCSetOperators(factor_, laplace_, laplace_));
  check(PCSetType(factor_, PCCHOLESKY));
  check(PCFactorSetMatSolverType(factor_, MATSOLVERMUMPS));
  check(PCSetFromOptions(factor_));
  check(PCSetUp(factor_));
}

void BlockPreconditioner::make_laplace() {
  OwnedMat scaled;
  OwnedVec root;
  check(MatDuplicate(system_.gradient, MAT_COPY_VALUES, scaled.fresh()));
  check(VecDuplicate(inverse_diagonal_, root.fresh()));
  check(VecCopy(inverse_diagonal_, root));
  check(VecSqrtAbs(root));
  check(MatDiagonalScale(scaled, root, nullptr));
  check(MatTransposeMatMult(scaled, scaled, MAT_INITIAL_MATRIX, PETSC_DEFAULT, laplace_.fresh()));
  // Pockets closed off from every pressure face, and pressures no free velocity sees, leave L singular but the
  // equations consistent: a shift far below L's other eigenvalues keeps the factor finite and the solution what it is.
  OwnedVec diagonal;
  PetscReal largest = 0;
  check(MatCreateVecs(laplace_, diagonal.fresh(), nullptr));
  check(MatGetDiagonal(laplace_, diagonal));
  check(VecMax(diagonal, nullptr, &largest));
  check(MatShift(laplace_, 1e-10 * largest));
  check(MatSetOption(laplace_, MAT_SPD, PETSC_TRUE));
}

void BlockPreconditioner::velocity(Vec residual, Vec correction) const {
  check(PCApply(multigrid_, residual, correction));
}

void BlockPreconditioner::pressure(Vec residual, Vec correction) const {
  check(PCApply(factor_, residual, inner_));
  check(MatMult(system_.gradient, inner_, gradient_));
  check(VecPointwiseMult(gradient_, gradient_, inverse_diagonal_));
  check(MatMult(system_.laplacian, gradient_, applied_));
  check(VecPointwiseMult(applied_, applied_, inverse_diagonal_));
  check(MatMultTranspose(system_.gradient, applied_, middle_));
  check(PCApply(factor_, middle_, correction));
}

double BlockPreconditioner::factor_entries() const {
  Mat factor = nullptr;
  check(PCFactorGetMatrix(factor_, &factor));
  MatInfo info;
  check(MatGetInfo(factor, MAT_GLOBAL_SUM, &info));
  return info.nz_used;
}

} // namespace reference::stokes_fem
