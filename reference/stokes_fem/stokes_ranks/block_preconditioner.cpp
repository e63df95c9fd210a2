#include "reference/stokes_fem/stokes_ranks/block_preconditioner.hpp"

#include <map>

namespace reference::stokes_fem {

namespace {

using Options = std::map<std::string, std::string>;

// What BoomerAMG does is chosen by PETSc's options only. HMIS, extended+i and P max 4 are what serves PFV's networks
// best; L, with its hundred neighbours of each pressure, wants the threshold.
void set_up(OwnedPc& cycle, Mat matrix, const std::string& prefix, const Options& more) {
  Options options{{"coarsen_type", "HMIS"}, {"interp_type", "ext+i"}, {"P_max", "4"}, {"strong_threshold", "0.5"}};
  options.insert(more.begin(), more.end());
  for (const auto& [name, value] : options)
    check(PetscOptionsSetValue(nullptr, ("-" + prefix + "pc_hypre_boomeramg_" + name).c_str(), value.c_str()));
  check(PCCreate(PetscObjectComm(reinterpret_cast<PetscObject>(matrix)), cycle.fresh()));
  check(PCSetOptionsPrefix(cycle, prefix.c_str()));
  check(PCSetOperators(cycle, matrix, matrix));
  check(PCSetType(cycle, PCHYPRE));
  check(PCHYPRESetType(cycle, "boomeramg"));
  check(PCSetFromOptions(cycle));
  check(PCSetUp(cycle));
}

} // namespace

BlockPreconditioner::BlockPreconditioner(const RankSystem& system) : system_(system) {
  const Mat laplacian = system.laplacian;
  check(MatCreateVecs(laplacian, inverse_diagonal_.fresh(), gradient_.fresh()));
  check(VecDuplicate(gradient_, applied_.fresh()));
  check(MatGetDiagonal(laplacian, inverse_diagonal_));
  check(VecReciprocal(inverse_diagonal_));
  make_laplace();
  check(MatCreateVecs(laplace_, inner_.fresh(), middle_.fresh()));

  set_up(velocity_cycle_, laplacian, "velocity_", {{"agg_nl", "1"}});
  set_up(pressure_cycle_, laplace_, "pressure_", {});
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
  // equations consistent: a shift far below L's other eigenvalues keeps the cycle finite and the solution what it is.
  OwnedVec diagonal;
  PetscReal largest = 0;
  check(MatCreateVecs(laplace_, diagonal.fresh(), nullptr));
  check(MatGetDiagonal(laplace_, diagonal));
  check(VecMax(diagonal, nullptr, &largest));
  check(MatShift(laplace_, 1e-10 * largest));
  check(MatSetOption(laplace_, MAT_SPD, PETSC_TRUE));
}

void BlockPreconditioner::velocity(Vec residual, Vec correction) const {
  check(PCApply(velocity_cycle_, residual, correction));
}

void BlockPreconditioner::pressure(Vec residual, Vec correction) const {
  check(PCApply(pressure_cycle_, residual, inner_));
  check(MatMult(system_.gradient, inner_, gradient_));
  check(VecPointwiseMult(gradient_, gradient_, inverse_diagonal_));
  check(MatMult(system_.laplacian, gradient_, applied_));
  check(VecPointwiseMult(applied_, applied_, inverse_diagonal_));
  check(MatMultTranspose(system_.gradient, applied_, middle_));
  check(PCApply(pressure_cycle_, middle_, correction));
}

} // namespace reference::stokes_fem
