// The flow on several ranks against the same mesh solved by one process in another way.

#include "meshing/void_mesh.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "reference/stokes_fem/flow_on_mesh.hpp"
#include "reference/stokes_fem/solve_on_ranks.hpp"
#include "reference/stokes_fem/stokes_fem.hpp"
#include "reference/temporary_folder.hpp"
#include "support/message_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace {

using pfv::Axis;
using pfv::Vec3;
using reference::Answer;
using reference::stokes_fem::SharedSolve;

constexpr double wall_limit = 500; // s

class Ranks : public ::testing::Test {
protected:
  void SetUp() override {
    setenv("PFV_MESH_CACHE", TEST_MESH_CACHE, 1);
    if (const auto reason = meshing::mesher_unavailable())
      GTEST_SKIP() << *reason;
    if (const auto reason = reference::stokes_fem::missing_ranks_program())
      GTEST_SKIP() << *reason;
  }

  static std::filesystem::path mesh(const pfv::Case& problem, double size) {
    return meshing::void_mesh(problem, {.mesh_size = size}, meshing::default_mesh_cache()).file;
  }

  static Answer answer(const pfv::Case& problem, double size, const reference::stokes_fem::Solve& solve,
                       const reference::Probes& probes = {}) {
    pfv::Clock clock;
    return reference::stokes_fem::flow_on_mesh(problem, mesh(problem, size), bridge_radius, clock, probes, solve);
  }

  static inline const double bridge_radius = meshing::MeshSettings{}.bridge_radius;
};

pfv::Case nine_spheres() {
  pfv::Case problem;
  problem.packing = pfv::nine_spheres();
  problem.faces = pfv::flow_along(Axis::z);
  return problem;
}

double rms(const std::vector<Vec3>& forces) {
  double sum = 0;
  for (const Vec3& force : forces)
    sum += force.squaredNorm();
  return std::sqrt(sum / static_cast<double>(forces.size()));
}

void expect_same(const Answer& alone, const Answer& shared) {
  EXPECT_NEAR(*shared.permeability / *alone.permeability, 1, 1e-7);
  EXPECT_EQ(shared.unknowns, alone.unknowns);
  EXPECT_EQ(shared.counts.at("free_unknowns"), alone.counts.at("free_unknowns"));
  for (std::size_t face = 0; face < 6; ++face)
    EXPECT_NEAR(shared.face_flux[face], alone.face_flux[face], 1e-6 * std::abs(alone.face_flux[5]));
  const double unit = rms(*alone.sphere_forces);
  for (std::size_t k = 0; k < alone.sphere_forces->size(); ++k)
    EXPECT_LT(((*shared.sphere_forces)[k] - (*alone.sphere_forces)[k]).norm(), 1e-6 * unit) << "sphere " << k;
  for (std::size_t face = 0; face < 6; ++face)
    EXPECT_LT(((*shared.wall_forces)[face] - (*alone.wall_forces)[face]).norm(), 1e-6 * unit) << "face " << face;
}

} // namespace

TEST_F(Ranks, GiveTheFlowOfOneProcess) {
  const auto problem = nine_spheres();
  const reference::Probes probes{{{0.5, 0.02, 0.02}, {0.05, 0.5, 0.3}},
                                 {{{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}}}};
  const auto alone = answer(problem, 2.5, reference::stokes_fem::SolverSettings{}, probes);
  for (const int ranks : {1, 2}) {
    const auto shared = answer(problem, 2.5, SharedSolve{ranks, wall_limit}, probes);
    SCOPED_TRACE(ranks);
    expect_same(alone, shared);
    EXPECT_EQ(shared.counts.at("ranks"), ranks);
    for (std::size_t k = 0; k < probes.points.size(); ++k)
      EXPECT_NEAR((*shared.point_pressures)[k], (*alone.point_pressures)[k], 1e-6);
    EXPECT_NEAR((*shared.facet_fluxes)[0], (*alone.facet_fluxes)[0], 1e-6 * std::abs(alone.face_flux[5]));
  }
}

// Nothing has a level: one pressure is held, and the mean gradient drives the flow through faces without end.
TEST_F(Ranks, GiveTheFlowOfOneProcessInABoxThatRepeats) {
  constexpr pfv::PeriodicAxes everywhere{true, true, true};
  pfv::Case problem;
  problem.packing = pfv::lattice_packing(pfv::Lattice::bcc, 0.45, 1, 1, everywhere);
  problem.faces = pfv::flow_along(Axis::x, 1, everywhere, problem.packing.box);
  const auto method = reference::make_stokes_fem();
  ASSERT_TRUE(method->runs_on_ranks());
  pfv::Clock clock;
  const auto alone = method->solve(problem, {.mesh_size = 2.5}, clock);
  expect_same(alone, method->solve(problem, {.mesh_size = 2.5, .ranks = 3}, clock));
  EXPECT_FALSE(alone.counts.contains("ranks"));
}

TEST_F(Ranks, OneThatIsKilledIsAFailureWithACause) {
  const char* program = std::getenv("PFV_STOKES_RANKS");
  const reference::TemporaryFolder folder("ranks_test");
  const auto script = folder.path() / "killed";
  std::ofstream(script) << "#!/bin/sh\n"
                           "if [ \"$OMPI_COMM_WORLD_RANK\" = 1 ]; then (sleep 0.3; kill -9 $$) & fi\n"
                           "exec "
                        << (program ? program : STOKES_RANKS_PATH) << " \"$@\"\n";
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  setenv("PFV_STOKES_RANKS", script.c_str(), 1);
  const auto message = pfv::testing::message_of<pfv::SolveError>([&] {
    answer(nine_spheres(), 2.5, SharedSolve{2, wall_limit});
  });
  program ? setenv("PFV_STOKES_RANKS", program, 1) : unsetenv("PFV_STOKES_RANKS");
  EXPECT_NE(message.find("process rank 1"), std::string::npos) << message;
  EXPECT_NE(message.find("signal 9"), std::string::npos) << message;
}

TEST_F(Ranks, OnesThatFailSayWhy) {
  pfv::Clock clock;
  const auto message = pfv::testing::message_of<pfv::SolveError>([&] {
    reference::stokes_fem::flow_on_mesh(nine_spheres(), "no_such.msh", bridge_radius, clock, {},
                                        SharedSolve{2, wall_limit});
  });
  EXPECT_NE(message.find("stokes_ranks: exit code 1"), std::string::npos) << message;
  EXPECT_NE(message.find("no $PhysicalNames in the mesh"), std::string::npos) << message;
}

TEST_F(Ranks, OnesThatTakeTooLongAreStopped) {
  const auto message = pfv::testing::message_of<pfv::SolveError>([&] {
    answer(nine_spheres(), 2.5, SharedSolve{2, 0.2});
  });
  EXPECT_NE(message.find("stokes_ranks: stopped after"), std::string::npos) << message;
}
