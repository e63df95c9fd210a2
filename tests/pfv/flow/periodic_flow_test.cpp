// Boxes that repeat: one cell of a lattice says what the endless lattice says, and nothing depends on where it is cut.
#include "pfv/flow/containing_pore.hpp"
#include "pfv/flow/fluxes.hpp"
#include "pfv/problem/generate.hpp"
#include "support/packings.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace pfv;
using namespace pfv::testing;

namespace {

constexpr PeriodicAxes everywhere{true, true, true};

Case periodic_flow(const Packing& packing, Axis axis = Axis::z, double drop = 1,
                   const PeriodicAxes& periodic = everywhere) {
  Case problem;
  problem.packing = packing;
  problem.faces = flow_along(axis, drop, periodic, packing.box);
  return problem;
}

Packing random_periodic(double ratio = 1) {
  RandomPacking asked{60, .5, ratio, 3, 1};
  asked.periodic = everywhere;
  return random_packing(asked);
}

struct TouchingLattice {
  Lattice lattice;
  double k_over_d2; // tests/data/pfv_lattice.csv
};
constexpr TouchingLattice touching[] = {
    {Lattice::simple_cubic, 2.46746e-3}, {Lattice::bcc, 5.1270e-4}, {Lattice::fcc, 1.58830e-4}};

TEST(PeriodicFlow, OneCellOfALatticeGivesItsClosedForm) {
  for (const auto& [lattice, expected] : touching)
    for (const int cells : {1, 2})
      for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
        const Packing packing = lattice_packing(lattice, touching_solid_fraction(lattice), cells, 1, everywhere);
        const auto flow = solved(periodic_flow(packing, axis));
        const double d = 2 * packing.spheres.front().radius;
        EXPECT_NEAR(flow.permeability.value() / (d * d) / expected, 1, 1e-4) << cells;
        EXPECT_NEAR((*flow.mean_flux)[index(axis)] / -*flow.permeability * cells, 1, 1e-9);
      }
}

TEST(PeriodicFlow, MayRepeatAlongSomeAxesOnly) {
  for (const auto& [lattice, expected] : touching)
    for (const PeriodicAxes periodic : {PeriodicAxes{true, true, false}, {false, false, true}, {true, false, false}}) {
      const Packing packing = lattice_packing(lattice, touching_solid_fraction(lattice), 1, 1, periodic);
      const double d = 2 * packing.spheres.front().radius;
      EXPECT_NEAR(*solved(periodic_flow(packing, Axis::z, 1, periodic)).permeability / (d * d) / expected, 1, 1e-4);
    }
}

TEST(PeriodicFlow, DoesNotDependOnWhereTheBoxIsCut) {
  for (const double ratio : {1.0, 3.0}) {
    const Packing packing = random_periodic(ratio);
    const double k = *solved(periodic_flow(packing)).permeability;
    Packing moved = packing;
    for (Sphere& sphere : moved.spheres) {
      sphere.centre += Vec3(.3, .55, .81);
      sphere.centre -= sphere.centre.array().floor().matrix();
    }
    EXPECT_NEAR(*solved(periodic_flow(moved)).permeability / k, 1, 1e-9);
  }
}

TEST(PeriodicFlow, OfTwoBoxesIsThatOfOne) {
  const Packing one = random_periodic();
  Packing two = one;
  two.box.upper.x() = 2;
  for (const Sphere& sphere : one.spheres)
    two.spheres.push_back({sphere.centre + Vec3::UnitX(), sphere.radius});
  for (const Axis axis : {Axis::x, Axis::z})
    EXPECT_NEAR(*solved(periodic_flow(two, axis)).permeability / *solved(periodic_flow(one, axis)).permeability, 1,
                1e-9);
}

TEST(PeriodicFlow, ScalesWithUnitsViscosityAndGradient) {
  const Packing packing = random_periodic(2);
  const double k = *solved(periodic_flow(packing)).permeability;
  Packing small{{1e-3 * packing.box.lower, 1e-3 * packing.box.upper}, {}};
  for (const auto& [centre, radius] : packing.spheres)
    small.spheres.push_back({1e-3 * centre, 1e-3 * radius});
  Case problem = periodic_flow(small, Axis::z, -250);
  problem.fluid.viscosity = 1e-3;
  EXPECT_NEAR(*solved(problem).permeability / (1e-6 * k), 1, 1e-9);
}

TEST(PeriodicFlow, PassesTheSameFluxThroughEveryPlane) {
  const auto flow = solved(periodic_flow(random_periodic(2), Axis::y));
  const Vec3 by_cut(flow.face_flux[1], flow.face_flux[3], flow.face_flux[5]); // areas are 1
  EXPECT_LT((*flow.mean_flux - by_cut).norm() / by_cut.norm(), 1e-9);
  EXPECT_LT(flow.mean_flux->y(), 0);
  EXPECT_GT(*flow.permeability, 0);
}

TEST(PeriodicFlow, BalancesInEveryPore) {
  const auto flow = solved(periodic_flow(random_periodic()));
  std::vector<double> balance(flow.network.pores.size(), 0);
  double largest = 0;
  for (std::size_t t = 0; t < flow.network.throats.size(); ++t) {
    const double q = throat_flux(flow.network, flow.system, flow.pressure, t);
    balance[flow.network.throats.pores[t][0]] -= q;
    balance[flow.network.throats.pores[t][1]] += q;
    largest = std::max(largest, std::abs(q));
  }
  ASSERT_EQ(flow.system.contracted_throats, 0u);
  for (const double b : balance)
    EXPECT_LT(std::abs(b), 1e-8 * largest); // in the pore that is held too
  EXPECT_EQ(flow.system.held_pores, 1u);
}

TEST(PeriodicFlow, ReciprocalGradients) { // the permeability tensor is symmetric
  const Packing packing = random_periodic(3);
  const Vec3 along_x = *solved(periodic_flow(packing, Axis::x)).mean_flux;
  const Vec3 along_y = *solved(periodic_flow(packing, Axis::y)).mean_flux;
  EXPECT_NEAR(along_x.y(), along_y.x(), 1e-10 * along_x.norm());
  EXPECT_GT(std::abs(along_x.y()), 1e-6 * along_x.norm());
}

TEST(PeriodicFlow, TakesItsLevelFromAPoint) {
  Case problem = periodic_flow(random_periodic());
  const auto plain = solved(problem);
  problem.pressure_points = {{Vec3(.01, .5, .98), 6}};
  const auto flow = solved(problem);
  const auto [pore, shift] = containing_pore(flow.network, problem.pressure_points[0].position);
  EXPECT_NEAR(flow.pressure[pore], 6 + shift[2], 1e-12);
  EXPECT_NEAR(*flow.permeability / *plain.permeability, 1, 1e-9);
  EXPECT_EQ(flow.system.held_pores, 0u);
  for (std::size_t i = 0; i < flow.pressure.size(); ++i)
    ASSERT_NEAR(flow.pressure[i] - plain.pressure[i], flow.pressure[0] - plain.pressure[0], 1e-9);
}

TEST(PeriodicFlow, SpheresCarryTheGradient) {
  for (const auto& packing : {random_periodic(3), lattice_packing(Lattice::fcc, .7, 1, 1, everywhere)}) {
    const auto flow = solved(periodic_flow(packing));
    EXPECT_LT((force_on_spheres(flow) + Vec3::UnitZ()).norm(), 1e-9); // - |grad p| V
  }
}

} // namespace
