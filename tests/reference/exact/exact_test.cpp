#include "reference/exact/exact.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <cstdlib>

namespace reference {
namespace {

pfv::Case two_sizes() {
  pfv::Case problem;
  problem.packing = {{pfv::Vec3::Zero(), {1, 2, 3}}, {{{0.5, 0.5, 0.5}, 0.1}, {{0.5, 1.5, 2}, 0.2}}};
  problem.fluid.viscosity = 1e-3;
  problem.faces = pfv::flow_along(pfv::Axis::y, 5.0);
  return problem;
}

Answer answer(double mesh_size) {
  pfv::Clock clock;
  return make_exact()->solve(two_sizes(), {mesh_size}, clock);
}

class Misbehaving : public ::testing::Test {
protected:
  void TearDown() override { unsetenv("PFV_EXACT"); }
};

TEST(Exact, ConvergesToOneAtOrderTwo) {
  const double coarse = *answer(1).permeability, fine = *answer(0.5).permeability, finest = *answer(0.25).permeability;
  EXPECT_NEAR(std::log2((coarse - fine) / (fine - finest)), 2, 1e-10);
  EXPECT_NEAR(fine + (fine - coarse) / 3, 1, 1e-14);
}

TEST(Exact, FluxIsThatOfThePermeability) {
  const Answer found = answer(1);
  const double expected = *found.permeability * (1 * 3) * 5 / (1e-3 * 2);
  EXPECT_DOUBLE_EQ(found.face_flux[pfv::index(pfv::Face::y_min)], expected);
  EXPECT_DOUBLE_EQ(found.face_flux[pfv::index(pfv::Face::y_max)], -expected);
  EXPECT_EQ(found.face_flux[pfv::index(pfv::Face::x_min)], 0);
}

TEST(Exact, ForcesGoByVolumeAndBalanceThePressureDrop) {
  const auto forces = answer(1).sphere_forces.value();
  EXPECT_NEAR((forces[0] + forces[1] + pfv::Vec3(0, 5 * 3, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR(forces[1].y() / forces[0].y(), 8, 1e-12);
}

TEST_F(Misbehaving, FailsOnDemand) {
  setenv("PFV_EXACT", "fail", 1);
  EXPECT_THROW(answer(1), pfv::SolveError);
}

TEST_F(Misbehaving, ThrowsSomethingElseOnDemand) {
  setenv("PFV_EXACT", "throw", 1);
  try {
    answer(1);
    FAIL() << "nothing thrown";
  } catch (const pfv::SolveError&) {
    FAIL() << "that is how a method fails properly";
  } catch (const std::runtime_error&) {
  }
}

TEST_F(Misbehaving, CrashesOnDemand) {
  setenv("PFV_EXACT", "crash", 1);
  EXPECT_EXIT(answer(1), ::testing::KilledBySignal(SIGABRT), "");
}

TEST_F(Misbehaving, RefusesAnUnknownWayToMisbehave) {
  setenv("PFV_EXACT", "sulk", 1);
  EXPECT_THROW(answer(1), pfv::InputError);
}

} // namespace
} // namespace reference
