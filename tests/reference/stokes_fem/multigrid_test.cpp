// The two ways to solve the inner systems give the same flow, and what they take is known beforehand.

#include "meshing/void_mesh.hpp"
#include "pfv/problem/generate.hpp"
#include "reference/memory_meter.hpp"
#include "reference/stokes_fem/flow_on_mesh.hpp"
#include "reference/stokes_fem/stokes_fem.hpp"

#include <cstdlib>
#include <gtest/gtest.h>

namespace {

using namespace reference::stokes_fem;

class InnerSolvers : public ::testing::Test {
protected:
  void SetUp() override {
    setenv("PFV_MESH_CACHE", TEST_MESH_CACHE, 1);
    if (const auto reason = reference::make_stokes_fem()->unavailable())
      GTEST_SKIP() << *reason;
  }

  static void expect_the_same(const pfv::Case& problem, double mesher_size) {
    const auto mesh = meshing::void_mesh(problem, {.mesh_size = mesher_size}, TEST_MESH_CACHE);
    const double bridge_radius = meshing::MeshSettings{}.bridge_radius;
    const auto answer = [&](const InnerSolves& inner) {
      pfv::Clock clock;
      return flow_on_mesh(problem, mesh.file, bridge_radius, clock, {}, SolverSettings{.inner = inner});
    };
    const reference::Answer exact = answer(Direct{}), iterated = answer(Multigrid{});
    EXPECT_NEAR(*iterated.permeability / *exact.permeability, 1, 1e-6);
    double largest = 0;
    for (const pfv::Vec3& force : *exact.sphere_forces)
      largest = std::max(largest, force.norm());
    for (std::size_t k = 0; k < exact.sphere_forces->size(); ++k)
      EXPECT_LT(((*iterated.sphere_forces)[k] - (*exact.sphere_forces)[k]).norm(), 1e-6 * largest);
    EXPECT_LT(iterated.counts.at("residual"), 1e-9);
    EXPECT_LT(iterated.counts.at("momentum_residual"), 1e-8);
    EXPECT_LT(iterated.counts.at("flux_imbalance"), 1e-6);
    EXPECT_EQ(iterated.counts.at("factor_entries"), 0);
    EXPECT_GT(exact.counts.at("factor_entries"), 0);
  }
};

pfv::Case periodic_lattice() {
  constexpr pfv::PeriodicAxes everywhere{true, true, true};
  pfv::Case problem;
  problem.packing = pfv::lattice_packing(pfv::Lattice::bcc, 0.45, 1, 1, everywhere);
  problem.faces = pfv::flow_along(pfv::Axis::z, 1, everywhere, problem.packing.box);
  return problem;
}

pfv::Case twelve_spheres() {
  pfv::Case problem;
  problem.packing = pfv::random_packing({.spheres = 12, .solid_fraction = 0.35, .radius_ratio = 1.35, .seed = 1});
  problem.faces = pfv::flow_along(pfv::Axis::z);
  return problem;
}

} // namespace

TEST_F(InnerSolvers, AgreeOnARandomPacking) {
  expect_the_same(twelve_spheres(), 2);
}

TEST_F(InnerSolvers, AgreeOnAPeriodicLattice) {
  expect_the_same(periodic_lattice(), 1.5);
}

TEST_F(InnerSolvers, TakeLessMemoryThanExpectedAndMoreThanHalf) {
  const auto method = reference::make_stokes_fem();
  const pfv::Case problem = twelve_spheres();
  const double expected = method->estimate(problem, {1.2}).memory_bytes;
  pfv::Clock clock;
  const reference::MemoryMeter memory;
  method->solve(problem, {1.2}, clock);
  const auto measured = static_cast<double>(memory.bytes());
  EXPECT_LT(measured, expected);
  EXPECT_GT(measured, expected / 2);
}
