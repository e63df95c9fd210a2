#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "reference/on_path.hpp"
#include "reference/openfoam/openfoam.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace reference {
namespace {

using pfv::Lattice;

class Snappy : public ::testing::Test {
protected:
  void SetUp() override {
    if (const auto reason = method_->unavailable())
      GTEST_SKIP() << *reason;
  }
  Answer answer(const pfv::Case& problem, double mesh_size) {
    pfv::Clock clock;
    return method_->solve(problem, {mesh_size}, clock);
  }
  const std::unique_ptr<Method> method_ = make_openfoam_snappy();
};

pfv::Case lattice(Lattice kind, double solid_fraction) {
  pfv::Case problem;
  problem.packing = pfv::lattice_packing(kind, solid_fraction, 1, 1);
  problem.faces = pfv::flow_along(pfv::Axis::z);
  return problem;
}

// Zick & Homsy (1982): K = 42.1 for touching spheres, k = d^2 / (18 phi K).
TEST_F(Snappy, TwoMeshesGiveTheTouchingSimpleCubicLattice) {
  const double solid = pfv::touching_solid_fraction(Lattice::simple_cubic);
  const auto problem = lattice(Lattice::simple_cubic, solid);
  const double exact = 1 / (18 * solid * 42.1);
  const double coarse = *answer(problem, 1.5).permeability / exact - 1;
  const double fine = *answer(problem, 1).permeability / exact - 1;
  EXPECT_LT(std::abs(fine), std::abs(coarse) / 1.5);
  const double extrapolated = fine + (fine - coarse) / (std::pow(1.5, *method_->convergence_order()) - 1);
  EXPECT_LT(std::abs(extrapolated), 0.02);
}

TEST_F(Snappy, HasTheVolumeAndCarriesThePressureDrop) {
  const auto problem = lattice(Lattice::simple_cubic, pfv::touching_solid_fraction(Lattice::simple_cubic));
  const auto found = answer(problem, 1.5);
  EXPECT_LT(std::abs(found.counts.at("volume_error")), 0.02);
  EXPECT_EQ(found.counts.at("bridges"), 6);
  pfv::Vec3 sum = pfv::Vec3::Zero();
  for (const pfv::Vec3& force : *found.sphere_forces)
    sum += force;
  EXPECT_NEAR((sum + pfv::Vec3::UnitZ()).norm(), 0, 0.02);
  EXPECT_LT(found.counts.at("flux_imbalance"), 1e-5);
}

// The same mesh, the same answer, however many share the work.
TEST_F(Snappy, RanksAgree) {
  if (!on_path("mpirun"))
    GTEST_SKIP() << "no mpirun";
  const auto problem = lattice(Lattice::simple_cubic, 0.4);
  pfv::Clock clock;
  const auto one = answer(problem, 2);
  const auto two = method_->solve(problem, {.mesh_size = 2, .ranks = 2}, clock);
  EXPECT_NEAR(*two.permeability / *one.permeability, 1, 1e-6);
  for (std::size_t k = 0; k < one.sphere_forces->size(); ++k)
    EXPECT_NEAR(((*two.sphere_forces)[k] - (*one.sphere_forces)[k]).norm(), 0, 1e-5) << k;
}

// Too coarse to see the pores: refused with the reason, not answered.
TEST_F(Snappy, RefusesAMeshThatLosesThePores) {
  const auto problem = lattice(Lattice::fcc, pfv::touching_solid_fraction(Lattice::fcc));
  EXPECT_THROW(answer(problem, 12), pfv::SolveError);
}

} // namespace
} // namespace reference
