// The conductance rule that is fitted to Stokes flow.
#include "pfv/flow/permeability_error.hpp"
#include "pfv/problem/generate.hpp"
#include "support/packings.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <random>

using namespace pfv;
using namespace pfv::testing;

namespace {

const FlowOptions calibrated{.conductance = Calibrated{}};

/// Over that of Stokes flow, k = d^2 / (18 phi K). Drag coefficients K: tests/data/README.md.
double over_stokes(Lattice lattice, double solid_fraction, double drag) {
  const Packing packing = lattice_packing(lattice, solid_fraction, 1);
  const double d = 2 * packing.spheres.front().radius;
  return *solved(flow_through(packing), calibrated).permeability * 18 * solid_fraction * drag / (d * d);
}

TEST(Calibrated, IsWithinSixPercentOfStokesFlowOnTouchingLattices) {
  EXPECT_NEAR(over_stokes(Lattice::simple_cubic, touching_solid_fraction(Lattice::simple_cubic), 42.1), 1, .06);
  EXPECT_NEAR(over_stokes(Lattice::bcc, touching_solid_fraction(Lattice::bcc), 162.78), 1, .06);
  EXPECT_NEAR(over_stokes(Lattice::fcc, touching_solid_fraction(Lattice::fcc), 432.12), 1, .06);
}

TEST(Calibrated, IsWithinSixPercentOnLooseLattices) {
  EXPECT_NEAR(over_stokes(Lattice::simple_cubic, .45, 28.0864), 1, .06);
  EXPECT_NEAR(over_stokes(Lattice::bcc, .45, 31.6882), 1, .06);
  EXPECT_NEAR(over_stokes(Lattice::fcc, .45, 33.4898), 1, .06);
  EXPECT_NEAR(over_stokes(Lattice::bcc, .6, 88.874), 1, .06);
  EXPECT_NEAR(over_stokes(Lattice::fcc, .6, 107.65), 1, .06);
}

TEST(Calibrated, IsThePapersRuleInATightThroat) {
  ThroatShape throat{.fluid_area = 1, .void_volume = 3, .wetted_surface = 20, .length = 2};
  EXPECT_DOUBLE_EQ(Calibrated{}(throat, 1), HydraulicRadius{}(throat, 1));
  double last = 1;
  for (const double openness : {1e-2, 1e-3, 1e-4, 1e-5}) {
    throat.openness = openness;
    const double off = std::abs(Calibrated{}(throat, 1) / HydraulicRadius{}(throat, 1) - 1);
    EXPECT_LT(off, .2 * last);
    last = off;
  }
}

TEST(Calibrated, ConductsMoreTheNearerTwoPoresAre) {
  double last = 0;
  for (double length = 1; length > 1e-12; length /= 4) {
    const ThroatShape throat{.fluid_area = 1,
                             .void_volume = length,
                             .wetted_surface = 4 * length,
                             .length = length,
                             .openness = .25,
                             .gap = .2,
                             .contrast = .5 * length / (1 + length)};
    const double conductance = Calibrated{}(throat, 1);
    EXPECT_GT(conductance, last);
    last = conductance;
  }
  EXPECT_GT(last, 1e8);
}

/// A square throat is two triangles in a periodic cell, cut by ties, and four quarters between walls.
TEST(Calibrated, DoesNotMindHowALatticeIsCut) {
  const PeriodicAxes all{true, true, true};
  for (const Lattice lattice : {Lattice::simple_cubic, Lattice::bcc, Lattice::fcc}) {
    Case cell = flow_through(lattice_packing(lattice, .45, 1, 1.0, all));
    const double between_walls = *solved(flow_through(lattice_packing(lattice, .45, 1)), calibrated).permeability;
    cell.faces = flow_along(Axis::z, 1.0, all, cell.packing.box);
    EXPECT_NEAR(*solved(cell, calibrated).permeability / between_walls, 1, 1e-9);
  }
}

/// Where spheres change partners a throat of no length turns around, and those that stay keep what they conduct.
TEST(Calibrated, HasNoJumpWhereTheTriangulationChanges) {
  const Packing start = random_packing({.spheres = 60, .solid_fraction = .45, .radius_ratio = 1.5, .seed = 3});
  const auto flow_at = [&](double stirred) {
    Packing packing = start;
    for (std::size_t k = 0; k < packing.spheres.size(); ++k) {
      const double angle = static_cast<double>(k * k);
      const Vec3 aside(std::cos(angle), std::sin(angle), std::sin(2 * angle));
      packing.spheres[k].centre += stirred * packing.spheres[k].radius * aside;
    }
    return solved(flow_through(packing), calibrated);
  };
  int changes = 0;
  for (double from = 0; from < .3; from += .01) {
    double low = from, high = from + .01;
    const std::size_t pores = flow_at(low).network.pores.size();
    if (flow_at(high).network.pores.size() == pores)
      continue;
    while (high - low > 1e-10) {
      const double middle = (low + high) / 2;
      (flow_at(middle).network.pores.size() == pores ? low : high) = middle;
    }
    const SteadyFlow before = flow_at(low), after = flow_at(high);
    EXPECT_NEAR(*before.permeability / *after.permeability, 1, 1e-6) << "at " << low;
    for (std::size_t k = 0; k < start.spheres.size(); ++k)
      EXPECT_LT((before.forces.of_flow(k) - after.forces.of_flow(k)).norm(), 1e-6) << "at " << low; // dp S is 1
    ++changes;
  }
  EXPECT_GT(changes, 2);
}

TEST(Calibrated, DoesNotMindPlaceNumbersOrUnits) {
  const Packing packing = packing_from("g200.txt");
  const double k = *solved(flow_through(packing), calibrated).permeability;
  Packing other = packing;
  const Vec3 shift(3.25, -7.5, 0.3);
  const auto moved = [&](const Vec3& v) -> Vec3 { return 1e-3 * (v + shift); };
  other.box = {moved(packing.box.lower), moved(packing.box.upper)};
  for (auto& sphere : other.spheres)
    sphere = {moved(sphere.centre), 1e-3 * sphere.radius};
  std::ranges::shuffle(other.spheres, std::mt19937_64(5));
  EXPECT_NEAR(*solved(flow_through(other), calibrated).permeability / (1e-6 * k), 1, 1e-9);
}

TEST(Calibrated, FollowsSpheresInPlace) {
  const Case problem = flow_through(packing_from("g200.txt"));
  Packing moved = problem.packing;
  for (auto& sphere : moved.spheres)
    sphere.radius *= .999;
  Clock clock;
  FollowedFlow followed(problem, calibrated, clock);
  followed.follow(moved, clock);
  EXPECT_NEAR(*followed.flow().permeability / *solved(flow_through(moved), calibrated).permeability, 1, 1e-8);
}

TEST(PermeabilityError, IsKnownWithinWhatTheRuleWasFittedTo) {
  const Packing packing = packing_from("g200.txt");
  EXPECT_FALSE(permeability_error({}, packing, .5));
  EXPECT_EQ(permeability_error(calibrated, packing, .5)->relative, Calibrated::permeability_error);
  EXPECT_EQ(permeability_error(calibrated, packing, .8)->outside,
            "fitted at solid fractions of 0.3 to 0.75, this is 0.2");
  FlowOptions no_slip = calibrated;
  no_slip.walls = NoSlipWalls{};
  EXPECT_EQ(permeability_error(no_slip, packing, .5)->outside, "fitted with mirror walls");
  Packing with_a_grain_of_dust = packing;
  with_a_grain_of_dust.spheres[0].radius /= 10;
  const auto error = permeability_error(calibrated, with_a_grain_of_dust, .5);
  EXPECT_FALSE(error->relative);
  EXPECT_TRUE(error->outside.starts_with("fitted up to a radius ratio of 5, this is 1")) << error->outside;
}

} // namespace
