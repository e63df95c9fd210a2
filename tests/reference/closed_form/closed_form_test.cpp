#include "reference/closed_form/closed_form.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "reference/closed_form/lattice_drag.hpp"
#include "reference/closed_form/recognise.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reference {
namespace {

using pfv::Lattice;

pfv::Case lattice_case(Lattice lattice, double fraction, int cells = 1, double cell_size = 1) {
  pfv::Case problem;
  problem.packing = pfv::lattice_packing(lattice, fraction, cells, cell_size);
  problem.faces = pfv::flow_along(pfv::Axis::z, 1.0);
  return problem;
}

Answer answer(const pfv::Case& problem) {
  pfv::Clock clock;
  return make_closed_form()->solve(problem, {}, clock);
}

class EveryLattice : public ::testing::TestWithParam<Lattice> {};
INSTANTIATE_TEST_SUITE_P(Cubic, EveryLattice, ::testing::Values(Lattice::simple_cubic, Lattice::bcc, Lattice::fcc));

TEST_P(EveryLattice, IsRecognisedShuffledAndMoved) {
  for (const int cells : {1, 2, 3}) {
    auto packing = pfv::lattice_packing(GetParam(), 0.3, cells, 2e-3);
    std::ranges::reverse(packing.spheres);
    const pfv::Vec3 shift(1, -2, 3);
    packing.box.lower += shift;
    packing.box.upper += shift;
    for (auto& sphere : packing.spheres)
      sphere.centre += shift;
    const auto found = recognise_lattice(packing);
    ASSERT_TRUE(found) << cells;
    EXPECT_EQ(found->lattice, GetParam());
    EXPECT_EQ(found->cells, cells);
    EXPECT_NEAR(found->solid_fraction, 0.3, 1e-12);
  }
}

// What is inside the box is the solid fraction that was asked for.
TEST_P(EveryLattice, CutSpheresCountByThePartInside) {
  const auto packing = pfv::lattice_packing(GetParam(), 0.3, 2);
  const auto found = recognise_lattice(packing).value();
  double solid = 0;
  for (std::size_t k = 0; k < packing.spheres.size(); ++k)
    solid += found.part_inside[k] * 4.0 / 3.0 * std::numbers::pi * std::pow(packing.spheres[k].radius, 3);
  EXPECT_NEAR(solid / packing.box.volume(), 0.3, 1e-12);
}

TEST_P(EveryLattice, TouchingSpheresAreTabulated) {
  const double touching = pfv::touching_solid_fraction(GetParam());
  const auto found = answer(lattice_case(GetParam(), touching, 2));
  EXPECT_NEAR(found.porosity.value(), 1 - touching, 1e-12);
  EXPECT_GT(found.counts.at("relative_error"), 0);
}

TEST_P(EveryLattice, ForcesBalanceThePressureDrop) {
  const auto problem = lattice_case(GetParam(), 0.343, 2, 0.5);
  const Answer found = answer(problem);
  pfv::Vec3 sum = pfv::Vec3::Zero();
  for (const auto& force : *found.sphere_forces)
    sum += force;
  EXPECT_NEAR((sum + pfv::Vec3::UnitZ()).norm(), 0, 1e-13);
}

// As phi -> 0 a sphere feels the Stokes drag with Hasimoto's (1959) first correction, K = 1 / (1 - c phi^(1/3) + phi
// ...), whose remainder is of order phi^2.
TEST_P(EveryLattice, DilutePermeabilityIsHasimotos) {
  const double c = GetParam() == Lattice::simple_cubic ? 1.7601 : 1.791;
  const auto row = lattice_drag(GetParam(), 0.001).value();
  EXPECT_NEAR(row.coefficient * (1 - c * 0.1 + 0.001), 1, 2e-4);
}

TEST_P(EveryLattice, DragGrowsWithTheSolidFraction) {
  double before = 1;
  for (const auto& row : lattice_drag_table())
    if (row.lattice == GetParam()) {
      EXPECT_GT(row.coefficient, before) << row.solid_fraction;
      before = row.coefficient;
    }
}

TEST(ClosedForm, PermeabilityScalesWithTheSquareOfLengthAndFluxWithViscosity) {
  auto large = lattice_case(Lattice::simple_cubic, 0.343), small = lattice_case(Lattice::simple_cubic, 0.343, 1, 1e-3);
  small.fluid.viscosity = 1e-3;
  const auto one = answer(large), other = answer(small);
  EXPECT_NEAR(*other.permeability / *one.permeability, 1e-6, 1e-16);
  EXPECT_NEAR(other.face_flux[4] / one.face_flux[4], 1e-6, 1e-16); // L^3 / mu
}

TEST(ClosedForm, MoreCellsDoNotChangeThePermeability) {
  EXPECT_NEAR(*answer(lattice_case(Lattice::bcc, 0.125, 3)).permeability,
              *answer(lattice_case(Lattice::bcc, 0.125, 1)).permeability, 1e-15);
}

TEST_P(EveryLattice, IsTheSameInAPeriodicBox) {
  const pfv::Case cut = lattice_case(GetParam(), 0.343, 2);
  for (const pfv::PeriodicAxes periodic : {pfv::PeriodicAxes{true, true, true}, {true, false, false}}) {
    pfv::Case problem;
    problem.packing = pfv::lattice_packing(GetParam(), 0.343, 2, 1, periodic);
    problem.faces = pfv::flow_along(pfv::Axis::z, 1, periodic, problem.packing.box);
    ASSERT_FALSE(make_closed_form()->not_covered(problem));
    EXPECT_NEAR(*answer(problem).permeability / *answer(cut).permeability, 1, 1e-14);
    EXPECT_NEAR(answer(problem).face_flux[4] / answer(cut).face_flux[4], 1, 1e-14);
    pfv::Vec3 force = pfv::Vec3::Zero();
    const Answer all = answer(problem);
    for (const pfv::Vec3& one : *all.sphere_forces)
      force += one;
    EXPECT_NEAR(force.z(), -4, 1e-12);
  }
}

TEST(ClosedForm, NamesTheTabulatedFractionsWhenThereIsNoneForTheCase) {
  const auto reason = make_closed_form()->not_covered(lattice_case(Lattice::simple_cubic, 0.3));
  ASSERT_TRUE(reason);
  EXPECT_NE(reason->find("0.343"), std::string::npos) << *reason;
}

TEST(ClosedForm, RefusesWhatIsNotALattice) {
  const auto method = make_closed_form();
  auto moved = lattice_case(Lattice::fcc, 0.343);
  moved.packing.spheres[3].centre.x() += 1e-6;
  EXPECT_TRUE(method->not_covered(moved));
  auto grown = lattice_case(Lattice::fcc, 0.343);
  grown.packing.spheres[3].radius *= 1 + 1e-6;
  EXPECT_TRUE(method->not_covered(grown));
  auto missing = lattice_case(Lattice::fcc, 0.343);
  missing.packing.spheres.pop_back();
  EXPECT_TRUE(method->not_covered(missing));
  auto twice = lattice_case(Lattice::fcc, 0.343);
  twice.packing.spheres[0] = twice.packing.spheres[1];
  EXPECT_TRUE(method->not_covered(twice));
}

TEST(ClosedForm, RefusesFlowAcrossSlipWalls) {
  auto problem = lattice_case(Lattice::simple_cubic, 0.343);
  problem.faces[0] = pfv::Pressure{0.5};
  EXPECT_TRUE(make_closed_form()->not_covered(problem));
}

} // namespace
} // namespace reference
