#include "pfv/solvers/amg_solver.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/solvers/conjugate_gradients.hpp"

#include <HYPRE.h>
#include <HYPRE_IJ_mv.h>
#include <HYPRE_parcsr_ls.h>
#include <cstdlib>
#include <fmt/format.h>
#include <mpi.h>
#include <numeric>
#include <type_traits>
#include <vector>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
using LeaksAllowed = __lsan::ScopedDisabler; // for MPI, which leaks; what leaks here is still found
#else
struct LeaksAllowed {
  ~LeaksAllowed() {}
};
#endif

namespace pfv {
namespace {

void start_hypre() {
  static const bool started = [] {
    const LeaksAllowed leaks_allowed;
    int mpi_is_initialised = 0;
    MPI_Initialized(&mpi_is_initialised);
    if (!mpi_is_initialised) {
      MPI_Init(nullptr, nullptr);
      std::atexit([] {
        const LeaksAllowed leaks_allowed_here;
        int mpi_is_finalised = 0;
        MPI_Finalized(&mpi_is_finalised);
        if (!mpi_is_finalised)
          MPI_Finalize();
      });
    }
    HYPRE_Init();
    return true;
  }();
  static_cast<void>(started);
}

void check(const char* action) {
  if (HYPRE_GetError() == 0)
    return;
  HYPRE_ClearAllErrors();
  throw SolveError(fmt::format("amg: hypre fails to {}", action));
}

template <auto destroy>
struct Destroy {
  template <class T>
  void operator()(T* object) const {
    destroy(object);
  }
};
template <class Handle, auto destroy>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Destroy<destroy>>;
using Matrix = Owned<HYPRE_IJMatrix, HYPRE_IJMatrixDestroy>;
using Vector = Owned<HYPRE_IJVector, HYPRE_IJVectorDestroy>;
using Cycle = Owned<HYPRE_Solver, HYPRE_BoomerAMGDestroy>;

Matrix hypre_matrix(const FlowMatrix& matrix, const std::vector<int>& rows) {
  HYPRE_IJMatrix handle = nullptr;
  const int last = static_cast<int>(matrix.rows()) - 1;
  HYPRE_IJMatrixCreate(MPI_COMM_SELF, 0, last, 0, last, &handle);
  Matrix copy(handle);
  std::vector<int> entries(rows.size());
  std::adjacent_difference(matrix.outerIndexPtr() + 1, matrix.outerIndexPtr() + matrix.rows() + 1, entries.begin());
  HYPRE_IJMatrixSetObjectType(handle, HYPRE_PARCSR);
  HYPRE_IJMatrixSetRowSizes(handle, entries.data());
  HYPRE_IJMatrixInitialize(handle);
  HYPRE_IJMatrixSetValues(handle, static_cast<int>(rows.size()), entries.data(), rows.data(), matrix.innerIndexPtr(),
                          matrix.valuePtr());
  HYPRE_IJMatrixAssemble(handle);
  check("take the matrix");
  return copy;
}

Vector hypre_vector(int size) {
  HYPRE_IJVector handle = nullptr;
  HYPRE_IJVectorCreate(MPI_COMM_SELF, 0, size - 1, &handle);
  Vector vector(handle);
  HYPRE_IJVectorSetObjectType(handle, HYPRE_PARCSR);
  HYPRE_IJVectorInitialize(handle);
  HYPRE_IJVectorAssemble(handle);
  return vector;
}

HYPRE_ParCSRMatrix object(const Matrix& matrix) {
  void* object = nullptr;
  HYPRE_IJMatrixGetObject(matrix.get(), &object);
  return static_cast<HYPRE_ParCSRMatrix>(object);
}

HYPRE_ParVector object(const Vector& vector) {
  void* object = nullptr;
  HYPRE_IJVectorGetObject(vector.get(), &object);
  return static_cast<HYPRE_ParVector>(object);
}

Cycle new_cycle() {
  constexpr int hmis = 10, extended_plus_i = 6, forward_gauss_seidel = 3, backward_gauss_seidel = 4, direct = 9;
  constexpr int down = 1, up = 2, coarsest = 3;
  HYPRE_Solver handle = nullptr;
  HYPRE_BoomerAMGCreate(&handle);
  HYPRE_BoomerAMGSetCoarsenType(handle, hmis);
  HYPRE_BoomerAMGSetInterpType(handle, extended_plus_i);
  HYPRE_BoomerAMGSetPMaxElmts(handle, 4);
  HYPRE_BoomerAMGSetStrongThreshold(handle, 0.5); // of 0.25 and 0.5 the one with the cheaper set-up
  HYPRE_BoomerAMGSetCycleRelaxType(handle, forward_gauss_seidel, down);
  HYPRE_BoomerAMGSetCycleRelaxType(handle, backward_gauss_seidel, up);
  HYPRE_BoomerAMGSetCycleRelaxType(handle, direct, coarsest);
  HYPRE_BoomerAMGSetRelaxOrder(handle, 0);
  HYPRE_BoomerAMGSetMaxIter(handle, 1);
  HYPRE_BoomerAMGSetTol(handle, 0);
  return Cycle(handle);
}

class BoomerAmg final : public Preconditioner {
public:
  BoomerAmg() { start_hypre(); }

  void analyse(const FlowMatrix& matrix) override {
    rows_.resize(static_cast<std::size_t>(matrix.rows()));
    std::iota(rows_.begin(), rows_.end(), 0);
    residual_ = hypre_vector(static_cast<int>(matrix.rows()));
    correction_ = hypre_vector(static_cast<int>(matrix.rows()));
  }

  void factor(const FlowMatrix& matrix) override {
    if (!(matrix.diagonal().minCoeff() > 0))
      throw SolveError("amg: the matrix is not positive definite, its diagonal is not positive");
    matrix_ = hypre_matrix(matrix, rows_);
    cycle_ = new_cycle();
    HYPRE_BoomerAMGSetup(cycle_.get(), object(matrix_), object(residual_), object(correction_));
    check("set up its levels");
  }

  double apply(const Eigen::VectorXd& residual, Eigen::VectorXd& correction) override {
    const int size = static_cast<int>(rows_.size());
    HYPRE_IJVectorSetValues(residual_.get(), size, rows_.data(), residual.data());
    HYPRE_ParVectorSetConstantValues(object(correction_), 0);
    HYPRE_BoomerAMGSolve(cycle_.get(), object(matrix_), object(residual_), object(correction_));
    HYPRE_ClearError(HYPRE_ERROR_CONV); // one cycle is not meant to converge
    check("cycle");
    HYPRE_IJVectorGetValues(correction_.get(), size, rows_.data(), correction.data());
    return residual.dot(correction);
  }

  void describe(SolverReport& report) const override {
    constexpr std::size_t bytes_per_unknown = 280; // measured on random packings; hypre does not tell
    report.memory_bytes = bytes_per_unknown * report.unknowns;
  }

private:
  std::vector<int> rows_;
  Matrix matrix_;
  Vector residual_, correction_;
  Cycle cycle_;
};

} // namespace

std::unique_ptr<FlowSolver> make_amg(const Amg& parameters) {
  return make_conjugate_gradients("amg", std::make_unique<BoomerAmg>(), parameters.tolerance);
}

} // namespace pfv
