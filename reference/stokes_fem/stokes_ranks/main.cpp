#include "meshing/periodic_images.hpp"
#include "pfv/clock.hpp"
#include "reference/stokes_fem/ranks_reply.hpp"
#include "reference/stokes_fem/stokes_ranks/rank_solver.hpp"
#include "reference/stokes_fem/unit_case.hpp"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <sys/prctl.h>

namespace reference::stokes_fem {

namespace {

const MPI_Comm ranks = MPI_COMM_WORLD;

double over_ranks(double value) {
  return dealii::Utilities::MPI::sum(value, ranks);
}

/// What is left of the whole mesh once each rank has its part.
struct Share {
  Numbering numbering;
  std::unique_ptr<MeshPart> part;
  std::unique_ptr<RankSystem> system;
  pfv::Vec3 mean_gradient;
  int without_equation = -1;
};

Share share_of(const pfv::Case& problem, const std::filesystem::path& mesh, double bridge_radius) {
  pfv::Case seen = problem;
  seen.packing = meshing::with_images(problem.packing, periodic_axes(problem.faces)).packing;
  const UnitCase unit = unit_case(seen);
  const auto space = discretise(mesh, unit.problem, unit.origin, unit.length, bridge_radius);
  const int count = static_cast<int>(dealii::Utilities::MPI::n_mpi_processes(ranks));
  share_cells(*space, count);
  const Boundary boundary = make_boundary(*space, unit.driving);
  Share share;
  share.numbering = number_unknowns(*space, boundary, count);
  share.part = part_of(*space, share.numbering, ranks);
  share.system = faces_system(boundary, unit.driving, share.numbering, ranks);
  share.mean_gradient = imposed_gradient(unit.driving);
  const bool has_level =
      std::ranges::any_of(unit.driving, [](const auto& face) { return std::holds_alternative<pfv::Pressure>(face); });
  if (!has_level)
    share.without_equation = share.numbering.pressure.front();
  return share;
}

std::vector<double> gathered(Vec values) {
  OwnedVec all;
  Owned<VecScatter, VecScatterDestroy> scatter;
  check(VecScatterCreateToZero(values, scatter.fresh(), all.fresh()));
  check(VecScatterBegin(scatter, values, all, INSERT_VALUES, SCATTER_FORWARD));
  check(VecScatterEnd(scatter, values, all, INSERT_VALUES, SCATTER_FORWARD));
  PetscInt size = 0;
  const PetscScalar* begin = nullptr;
  check(VecGetLocalSize(all, &size));
  check(VecGetArrayRead(all, &begin));
  std::vector<double> copy(begin, begin + size);
  check(VecRestoreArrayRead(all, &begin));
  return copy;
}

Eigen::VectorXd by_node(const std::vector<double>& values, const std::vector<int>& number) {
  Eigen::VectorXd nodal(static_cast<Eigen::Index>(number.size()));
  for (std::size_t node = 0; node < number.size(); ++node)
    nodal[static_cast<Eigen::Index>(node)] = number[node] >= 0 ? values[static_cast<std::size_t>(number[node])] : 0;
  return nodal;
}

void write(const RankSolution& solution, const Numbering& numbering, const RanksReply& reply) {
  const auto velocity = gathered(solution.velocity);
  const auto pressure = gathered(solution.pressure);
  if (dealii::Utilities::MPI::this_mpi_process(ranks) != 0)
    return;
  FlowField flow;
  for (std::size_t c = 0; c < 3; ++c)
    flow.velocity[c] = by_node(velocity, numbering.velocity[c]);
  flow.pressure = by_node(pressure, numbering.pressure);
  write_flow(flow, "flow");
  std::ofstream out("reply.json");
  out << to_json(reply) << '\n';
  if (!out.flush())
    throw std::runtime_error("cannot write reply.json");
}

void answer(const std::filesystem::path& mesh, double bridge_radius) {
  Share share = share_of(pfv::read_case("case.toml"), mesh, bridge_radius);
  add_cells(*share.part, share.numbering, share.mean_gradient, share.without_equation, *share.system);
  share.part.reset();
  RanksReply reply;
  reply.assemble_seconds = over_ranks(pfv::process_cpu_seconds());
  const BlockPreconditioner preconditioner(*share.system);
  reply.velocity_nodes = share.numbering.velocity[0].size();
  reply.pressure_nodes = share.numbering.pressure.size();
  reply.free_velocities = share.system->laplacian.m();
  reply.factor_seconds = over_ranks(pfv::process_cpu_seconds()) - reply.assemble_seconds;
  const auto solution = solve(*share.system, preconditioner, RankSolverSettings{});
  reply.face_flux = solution->face_flux;
  reply.dissipation = solution->dissipation;
  reply.residual = solution->residual;
  reply.imbalance = solution->imbalance;
  reply.iterations = solution->iterations;
  reply.solve_seconds = over_ranks(pfv::process_cpu_seconds()) - reply.assemble_seconds - reply.factor_seconds;
  reply.peak_memory = over_ranks(static_cast<double>(pfv::peak_memory_bytes()));
  write(*solution, share.numbering, reply);
}

} // namespace

} // namespace reference::stokes_fem

#ifdef __SANITIZE_ADDRESS__
/// MPI and PETSc leak; what leaks here is still found.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libmpi\nleak:libopen\nleak:libpmix\nleak:mca_\nleak:libpetsc\nleak:libHYPRE\n";
}
#endif

/// stokes_ranks mesh bridge_radius, in a folder with case.toml; writes reply.json and flow there.
/// Exit code 1 with the reason in failure.txt.
int main(int argc, char** argv) {
  using namespace reference::stokes_fem;
  if (argc != 3) {
    std::fprintf(stderr, "usage: stokes_ranks mesh bridge_radius\n");
    return 2;
  }
  const std::string mesh = argv[1];
  const double bridge_radius = std::strtod(argv[2], nullptr);
  prctl(PR_SET_PDEATHSIG, SIGKILL); // mpirun gives its ranks process groups of their own
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try {
    check(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));
    answer(mesh, bridge_radius);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    std::ofstream("failure.txt") << error.what() << '\n';
  }
  MPI_Abort(MPI_COMM_WORLD, 1);
}
