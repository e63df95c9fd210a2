#include "reference/lattice_boltzmann/lattice_boltzmann.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "reference/closed_form/closed_form.hpp"
#include "reference/lattice_boltzmann/program.hpp"
#include "support/message_of.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace reference {
namespace {

using pfv::Axis;
using pfv::Lattice;
using pfv::Vec3;

pfv::Case through(const pfv::Packing& packing, const pfv::PeriodicAxes& periodic = {}, Axis axis = Axis::z,
                  double drop = 1) {
  pfv::Case problem;
  problem.packing = packing;
  problem.faces = pfv::flow_along(axis, drop, periodic, packing.box);
  return problem;
}

constexpr pfv::PeriodicAxes everywhere{true, true, true};

double total(const std::vector<Vec3>& forces, int axis) {
  double sum = 0;
  for (const Vec3& force : forces)
    sum += force[axis];
  return sum;
}

class LatticeBoltzmann : public ::testing::Test {
protected:
  void SetUp() override {
    if (const auto reason = method_->unavailable())
      GTEST_SKIP() << *reason;
  }
  Answer answer(const pfv::Case& problem, double mesh_size, const Probes& probes = {}, int ranks = 1) {
    pfv::Clock clock;
    return method_->solve(problem, {mesh_size, ranks, probes}, clock);
  }
  double tabulated(const pfv::Case& problem) {
    pfv::Clock clock;
    return *make_closed_form()->solve(problem, {}, clock).permeability;
  }
  const std::unique_ptr<Method> method_ = make_lattice_boltzmann();
};

TEST_F(LatticeBoltzmann, GivesTheTabulatedPermeabilityOfALattice) {
  const auto problem = through(pfv::lattice_packing(Lattice::simple_cubic, 0.343, 1));
  EXPECT_NEAR(*answer(problem, 1).permeability / tabulated(problem), 1, 0.02);
}

// Mirrors and antisymmetric pressure planes are exact: the same numbers as by the repeated cell, but for round-off and
// what is still to come when the flow is taken to be at rest.
TEST_F(LatticeBoltzmann, ABoxBetweenMirrorsIsTheCellOfTheLattice) {
  for (const auto lattice : {Lattice::simple_cubic, Lattice::bcc, Lattice::fcc}) {
    const auto cell = answer(through(pfv::lattice_packing(lattice, 0.45, 1, 1, everywhere), everywhere), 1.6);
    const auto box = answer(through(pfv::lattice_packing(lattice, 0.45, 1)), 1.6);
    EXPECT_NEAR(*box.permeability / *cell.permeability, 1, 1e-4);
    EXPECT_NEAR(*box.porosity, *cell.porosity, 1e-12);
    EXPECT_NEAR(total(*box.sphere_forces, 2), total(*cell.sphere_forces, 2), 1e-4);
  }
}

TEST_F(LatticeBoltzmann, SpheresCarryTheDropTimesTheArea) {
  auto problem =
      through(pfv::random_packing({.spheres = 9, .solid_fraction = 0.4, .radius_ratio = 1.5}), {}, Axis::x, 3e4);
  problem.fluid.viscosity = 1e-3;
  const auto found = answer(problem, 1.5);
  EXPECT_NEAR(total(*found.sphere_forces, 0) / 3e4, -1, 1e-4);
  EXPECT_EQ(found.face_flux[0], -found.face_flux[1]);
  EXPECT_GT(found.face_flux[0], 0); // out at the lower face
  EXPECT_NEAR(1e-3 * found.face_flux[0] / 3e4, *found.permeability, 1e-9 * *found.permeability);
  EXPECT_LT(found.counts.at("force_imbalance"), 1e-4);
  EXPECT_LT(found.counts.at("flux_imbalance"), 0.05);
}

TEST_F(LatticeBoltzmann, SymmetricCornersOfABoxBearTheSameForce) {
  const auto found = answer(through(pfv::lattice_packing(Lattice::bcc, 0.6, 1)), 1.5);
  const auto& forces = *found.sphere_forces;
  ASSERT_EQ(forces.size(), 9U);
  const double eighth = std::abs(total(forces, 2)) / 16;
  for (const Vec3& force : forces) {
    EXPECT_NEAR(force.x(), 0, 1e-6 * eighth);
    EXPECT_NEAR(force.y(), 0, 1e-6 * eighth);
    const bool middle = std::abs(force.z()) > 4 * eighth;
    EXPECT_NEAR(force.z() / eighth, middle ? -8 : -1, 1e-3);
  }
}

TEST_F(LatticeBoltzmann, TurnsWithTheAxisAndGrowsWithTheUnits) {
  const pfv::RandomPacking made{.spheres = 5, .solid_fraction = 0.3};
  const auto along_z = answer(through(pfv::random_packing(made)), 2);
  pfv::Packing turned = pfv::random_packing(made);
  for (auto& [centre, radius] : turned.spheres) {
    centre = 1e-3 * Vec3(centre.z(), centre.x(), centre.y());
    radius *= 1e-3;
  }
  turned.box.upper *= 1e-3;
  const auto along_x = answer(through(turned, {}, Axis::x), 2);
  EXPECT_NEAR(*along_x.permeability / *along_z.permeability, 1e-6, 1e-11);
}

TEST_F(LatticeBoltzmann, PressuresFollowTheDropAndFluxesTheSections) {
  Probes probes;
  probes.points = {{0.02, 0.03, 0}, {0.02, 0.03, 0.5}, {0.02, 0.03, 1}, {0.5, 0.5, 0.5}};
  for (const double z : {0.1, 0.5, 0.8})
    probes.facets.push_back({{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}});
  auto problem = through(pfv::lattice_packing(Lattice::simple_cubic, 0.343, 1), {}, Axis::z, 2);
  problem.faces[4] = pfv::Pressure{5};
  problem.faces[5] = pfv::Pressure{7};
  const auto found = answer(problem, 1, probes);
  ASSERT_EQ(found.point_pressures->size(), 4U);
  EXPECT_NEAR((*found.point_pressures)[0], 5, 1e-6);
  EXPECT_NEAR((*found.point_pressures)[1], 6, 1e-4);
  EXPECT_NEAR((*found.point_pressures)[2], 7, 1e-6);
  EXPECT_TRUE(std::isnan((*found.point_pressures)[3])); // in the sphere
  for (const double flux : *found.facet_fluxes)
    EXPECT_NEAR(flux / found.face_flux[5], 1, 0.02);
}

TEST_F(LatticeBoltzmann, RanksGiveTheSameAnswer) {
  const auto problem =
      through(pfv::lattice_packing(Lattice::bcc, 0.343, 1, 1, {true, false, false}), {true, false, false});
  const auto alone = answer(problem, 2);
  const auto shared = answer(problem, 2, {}, 2);
  EXPECT_NEAR(*shared.permeability / *alone.permeability, 1, 1e-10);
  for (std::size_t k = 0; k < alone.sphere_forces->size(); ++k)
    EXPECT_NEAR(((*shared.sphere_forces)[k] - (*alone.sphere_forces)[k]).norm(), 0, 1e-9);
}

TEST_F(LatticeBoltzmann, DoesNotDependOnTheViscosityOfItsSteps) {
  lattice_boltzmann::FlowQuestion question;
  question.voxels = {16, 16, 16};
  question.spheres = {{{8.2, 7.9, 8.1}, 6.3}, {{0.3, 0.1, 15.8}, 4.4}};
  question.tolerance = 1e-7;
  const auto conductance = [&](double viscosity) {
    question.viscosity = viscosity;
    return viscosity * lattice_boltzmann::run_lattice_flow(question, 1, 60).velocity;
  };
  const double one = conductance(1);
  EXPECT_NEAR(conductance(0.2) / one, 1, 1e-5);
  EXPECT_NEAR(conductance(0.05) / one, 1, 1e-5);
}

// Measured, not derived: within a factor of 2.5, which the budget of a study leaves room for.
TEST_F(LatticeBoltzmann, KnowsItsCostBeforehand) {
  for (const auto& packing : {pfv::lattice_packing(Lattice::bcc, 0.45, 1), pfv::nine_spheres(),
                              pfv::random_packing({.spheres = 30, .solid_fraction = 0.4})}) {
    const auto problem = through(packing);
    const auto expected = method_->estimate(problem, {1.4, 1, {}});
    const auto found = answer(problem, 1.4);
    EXPECT_NEAR(expected.unknowns / static_cast<double>(found.unknowns), 1, 0.1);
    EXPECT_NEAR(std::log(expected.memory_bytes / found.counts.at(memory_count)), 0, std::log(1.3));
    const double per_step = 4.2e-8 * found.counts.at("voxels");
    EXPECT_NEAR(std::log((expected.cpu_seconds - 0.2) / per_step / found.counts.at("steps")), 0, std::log(2.5));
  }
}

TEST_F(LatticeBoltzmann, OneThatDoesNotEndIsStopped) {
  lattice_boltzmann::FlowQuestion question;
  question.voxels = {40, 40, 40};
  question.spheres = {{{20, 20, 20}, 10}};
  question.tolerance = 0;
  const auto message =
      pfv::testing::message_of<pfv::SolveError>([&] { lattice_boltzmann::run_lattice_flow(question, 1, 0.5); });
  EXPECT_NE(message.find("lattice_flow: stopped after"), std::string::npos) << message;
}

TEST_F(LatticeBoltzmann, VoxelsWithoutAWayThroughAreAFailureWithACause) {
  const auto packing = pfv::Packing{{}, {{{0.5, 0.5, 0.5}, 0.8}}};
  const auto message = pfv::testing::message_of<pfv::SolveError>([&] { answer(through(packing), 5); });
  EXPECT_NE(message.find("no way through the voxels"), std::string::npos) << message;
}

TEST_F(LatticeBoltzmann, RefusesWhatItDoesNotKnow) {
  auto problem = through(pfv::lattice_packing(Lattice::simple_cubic, 0.343, 1));
  const auto refusal = [&] { return method_->not_covered(problem).value_or(""); };
  EXPECT_EQ(refusal(), "");
  problem.faces[5] = pfv::Pressure{1, pfv::Tangential::free};
  EXPECT_TRUE(refusal().starts_with("free tangential flow along z_max")) << refusal();
  problem.faces[5] = pfv::Flux{1};
  EXPECT_TRUE(refusal().starts_with("needs different pressures")) << refusal();
  problem.faces = pfv::flow_along(Axis::z);
  problem.pressure_points = {{{0.1, 0.1, 0.1}, 1}};
  EXPECT_TRUE(refusal().starts_with("a pressure at a point")) << refusal();
  problem.pressure_points.clear();
  problem.packing.spheres[0].radius = 0.4;
  problem.packing.box.upper = {1, 0.7071, 0.8912};
  EXPECT_TRUE(refusal().starts_with("cubic voxels misfit the sides of the box by")) << refusal();
}

} // namespace
} // namespace reference
