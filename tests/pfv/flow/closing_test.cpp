// Spheres that grow until they close the throats between them.
#include "pfv/flow/flow_options.hpp"
#include "pfv/problem/generate.hpp"
#include "support/packings.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace pfv;
using namespace pfv::testing;

namespace {

Packing simple_cubic(double radius) {
  Packing packing = lattice_packing(Lattice::simple_cubic, touching_solid_fraction(Lattice::simple_cubic), 3);
  for (auto& sphere : packing.spheres)
    sphere.radius = radius;
  return packing;
}

Packing grown(double by) {
  Packing packing = packing_from("g200.txt");
  for (auto& sphere : packing.spheres)
    sphere.radius *= by;
  return packing;
}

/// What all spheres and faces carry together.
double unbalanced(const SteadyFlow& flow) {
  Vec3 sum = force_on_spheres(flow);
  for (const Vec3& force : flow.forces.on_face)
    sum += force;
  return sum.norm();
}

const double closed_at = std::sqrt(.5);

TEST(Closing, TakesThePermeabilityOfALatticeToZero) {
  double last = *solved(flow_through(simple_cubic(.5))).permeability;
  for (const double missing : {.2, .1, .05, .01, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const SteadyFlow flow = solved(flow_through(simple_cubic(closed_at - missing)));
    EXPECT_GT(*flow.permeability, 0) << missing;
    EXPECT_LT(*flow.permeability, last) << missing;
    EXPECT_LT(*flow.permeability, 0.06 * missing * missing) << missing; // as the hole's area
    EXPECT_EQ(flow.network.closed_throats, 0u);
    last = *flow.permeability;
  }
}

TEST(Closing, LeavesNoWayThroughALattice) {
  for (const double radius : {closed_at + 1e-9, .75, .85, .9}) // from .866 on the last void is gone too
    for (const SolverChoice& solver : {SolverChoice(Cholmod{}), SolverChoice(Multigrid{}), SolverChoice(GaussSeidel{})})
      for (const Conductance& rule :
           {Conductance(HydraulicRadius{}), Conductance(MixedArea{}), Conductance(Calibrated{})}) {
        const SteadyFlow flow = solved(flow_through(simple_cubic(radius)), {.conductance = rule, .solver = solver});
        EXPECT_EQ(*flow.permeability, 0) << radius;
        EXPECT_EQ(flow.flux_in + flow.flux_out, 0);
        EXPECT_GT(flow.network.closed_throats, 100u);
        EXPECT_GT(flow.system.isolated_pores, 0u);
        EXPECT_NEAR(force_on_spheres(flow).z(), -9, 1e-12); // the drop over the section
        EXPECT_NEAR(unbalanced(flow), 0, 1e-12);
      }
}

TEST(Closing,
     LeavesNoJumpOfThePermeability) { // random: throats close, pores are cut off and centres pass through spheres
  const double step = 1e-7;
  for (double by = 1.11; by < 1.45; by += .0171) {
    const SteadyFlow flow = solved(flow_through(grown(by)));
    const double after = *solved(flow_through(grown(by + step))).permeability;
    EXPECT_LT(after, *flow.permeability) << by;
    EXPECT_NEAR(after / *flow.permeability, 1, 100 * step) << by; // d ln k / d ln r of -20 to -60
    EXPECT_NEAR(unbalanced(flow), 0, 1e-12);
  }
}

TEST(Closing, StopsAFlowThatWouldBeRoundOff) { // some pores still lead to one face, none from one to the other
  Packing packing = packing_from("g2000.txt");
  for (auto& sphere : packing.spheres)
    sphere.radius *= 1.5;
  const SteadyFlow flow = solved(flow_through(packing));
  EXPECT_GT(flow.system.unknowns(), 0u);
  EXPECT_EQ(*flow.permeability, 0);
}

} // namespace
