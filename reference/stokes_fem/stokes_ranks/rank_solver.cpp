#include "reference/stokes_fem/stokes_ranks/rank_solver.hpp"

#include "reference/stokes_fem/flux_imbalance.hpp"

#include <cstdio>

namespace reference::stokes_fem {

namespace {

std::array<Vec, 2> parts(Vec both) {
  std::array<Vec, 2> part{};
  check(VecNestGetSubVec(both, 0, &part[0]));
  check(VecNestGetSubVec(both, 1, &part[1]));
  return part;
}

// No exception may cross the C of PETSc, which hands codes on.
PetscErrorCode apply(PC shell, Vec residual, Vec correction) {
  try {
    void* context = nullptr;
    check(PCShellGetContext(shell, &context));
    const auto& preconditioner = *static_cast<const BlockPreconditioner*>(context);
    const auto from = parts(residual);
    const auto to = parts(correction);
    preconditioner.velocity(from[0], to[0]);
    preconditioner.pressure(from[1], to[1]);
    return 0;
  } catch (const std::exception&) {
    return PETSC_ERR_LIB;
  }
}

std::array<double, 6> fluxes(const RankSystem& system, Vec velocity) {
  std::array<double, 6> flux{};
  for (std::size_t face = 0; face < 6; ++face)
    if (system.outflow[face].size() != 0)
      check(VecDot(system.outflow[face], velocity, &flux[face]));
  return flux;
}

struct Watch {
  const RankSystem& system;
  const RankSolverSettings& settings;
  RankSolution& solution;
  double start = 0;
};

PetscErrorCode look(KSP solver, PetscInt iteration, PetscReal residual, KSPConvergedReason* reason, void* context) {
  auto& watch = *static_cast<Watch*>(context);
  RankSolution& solution = watch.solution;
  if (iteration == 0)
    watch.start = residual;
  solution.iterations = static_cast<int>(iteration);
  solution.residual = watch.start > 0 ? residual / watch.start : 0;
  *reason = KSP_CONVERGED_ITERATING;
  if (watch.start > 0 && solution.residual >= watch.settings.residual) {
    if (iteration == watch.settings.iterations)
      *reason = KSP_DIVERGED_ITS;
    return 0;
  }
  try {
    Vec both = nullptr;
    check(KSPBuildSolution(solver, nullptr, &both));
    solution.imbalance = flux_imbalance(fluxes(watch.system, parts(both)[0]));
  } catch (const std::exception&) {
    return PETSC_ERR_LIB;
  }
  if (solution.imbalance < watch.settings.imbalance)
    *reason = KSP_CONVERGED_RTOL;
  return 0;
}

void require_convergence(KSP solver, const RankSolution& solution, const RankSolverSettings& settings) {
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  check(KSPGetConvergedReason(solver, &reason));
  if (reason > 0)
    return;
  char text[250];
  std::snprintf(text, sizeof text,
                "Stokes solver on ranks: after %d iterations residual %.1e (%.1e allowed), |inflow/outflow - 1| %.1e "
                "(%.1e allowed): %s",
                solution.iterations, solution.residual, settings.residual, solution.imbalance, settings.imbalance,
                KSPConvergedReasons[reason]);
  throw std::runtime_error(text);
}

} // namespace

std::unique_ptr<RankSolution> solve(const RankSystem& system, const BlockPreconditioner& preconditioner,
                                    const RankSolverSettings& settings) {
  const MPI_Comm ranks = system.laplacian.get_mpi_communicator();
  auto solution = std::make_unique<RankSolution>();
  check(MatCreateVecs(system.gradient, solution->pressure.fresh(), solution->velocity.fresh()));
  OwnedVec no_source;
  check(VecDuplicate(solution->pressure, no_source.fresh()));
  check(VecSet(no_source, 0));

  // MINRES wants symmetry, so the second row is turned: -gradient^T u = 0.
  OwnedMat negative_gradient;
  OwnedMat negative_divergence;
  OwnedMat equations;
  check(MatDuplicate(system.gradient, MAT_COPY_VALUES, negative_gradient.fresh()));
  check(MatScale(negative_gradient, -1));
  check(MatCreateTranspose(negative_gradient, negative_divergence.fresh()));
  std::array<Mat, 4> blocks{system.laplacian, negative_gradient, negative_divergence, nullptr};
  check(MatCreateNest(ranks, 2, nullptr, 2, nullptr, blocks.data(), equations.fresh()));
  OwnedVec load;
  OwnedVec unknowns;
  std::array<Vec, 2> loads{system.load, no_source};
  std::array<Vec, 2> all{solution->velocity, solution->pressure};
  check(VecCreateNest(ranks, 2, nullptr, loads.data(), load.fresh()));
  check(VecCreateNest(ranks, 2, nullptr, all.data(), unknowns.fresh()));

  OwnedKsp solver;
  PC shell = nullptr;
  Watch watch{system, settings, *solution};
  check(KSPCreate(ranks, solver.fresh()));
  check(KSPSetOperators(solver, equations, equations));
  check(KSPSetType(solver, KSPMINRES));
  check(KSPSetTolerances(solver, 0, 0, PETSC_DEFAULT, settings.iterations));
  check(KSPSetConvergenceTest(solver, look, &watch, nullptr));
  check(KSPGetPC(solver, &shell));
  check(PCSetType(shell, PCSHELL));
  check(PCShellSetContext(shell, const_cast<BlockPreconditioner*>(&preconditioner)));
  check(PCShellSetApply(shell, apply));
  check(KSPSetFromOptions(solver));
  check(KSPSolve(solver, load, unknowns));
  require_convergence(solver, *solution, settings);
  solution->face_flux = fluxes(system, solution->velocity);
  check(VecDot(system.load, solution->velocity, &solution->dissipation));
  return solution;
}

} // namespace reference::stokes_fem
