// Viscous forces evened out between neighbours.
#include "pfv/problem/generate.hpp"
#include "support/packings.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace pfv;
using namespace pfv::testing;

namespace {

const FlowOptions calibrated{.conductance = Calibrated{}};

FlowOptions spreading(double share) {
  Calibrated rule;
  rule.shear_spread = share;
  return {.conductance = rule};
}

Vec3 viscous_on_spheres(const SteadyFlow& flow) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& force : flow.forces.viscous)
    sum += force;
  return sum;
}

/// Rms difference of the forces on the first `count` spheres over their rms force, those of `other` times a factor.
double difference(const FluidForces& forces, const FluidForces& other, std::size_t count, double factor) {
  double squares = 0, whole = 0;
  for (std::size_t k = 0; k < count; ++k) {
    squares += (factor * other.of_flow(k) - forces.of_flow(k)).squaredNorm();
    whole += forces.of_flow(k).squaredNorm();
  }
  return std::sqrt(squares / whole);
}

Packing random_with(std::uint64_t seed, double radius_ratio) {
  return random_packing({.spheres = 60, .solid_fraction = .45, .radius_ratio = radius_ratio, .seed = seed});
}

TEST(ShearSpread, LosesNoForce) {
  for (const auto& packing : {packing_from("g200.txt"), packing_from("bcc9.txt"), random_with(3, 4)})
    for (const WallRule& walls : {WallRule(MirrorWalls{}), WallRule(NoSlipWalls{})}) {
      FlowOptions options = calibrated;
      options.walls = walls;
      const auto flow = solved(flow_through(packing, Axis::y), options);
      Vec3 sum = force_on_spheres(flow);
      for (const Vec3& force : flow.forces.on_face)
        sum += force;
      EXPECT_LT(sum.norm(), 1e-10);
    }
}

TEST(ShearSpread, LeavesThePressureDropToTheSpheres) {
  const Packing packing = packing_from("g200.txt");
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    const double along = force_on_spheres(solved(flow_through(packing, axis), calibrated))[index(axis)];
    EXPECT_NEAR(along, -packing.box.size().prod() / packing.box.size()[index(axis)], 1e-10);
  }
}

TEST(ShearSpread, LeavesPeriodicForcesAltogetherAsTheyAre) {
  const PeriodicAxes all{true, true, true};
  Case cell = flow_through(random_packing({.spheres = 40, .solid_fraction = .5, .seed = 2, .periodic = all}));
  cell.faces = flow_along(Axis::z, 1.0, all, cell.packing.box);
  const auto by_throat = solved(cell, spreading(0)), spread = solved(cell, calibrated);
  EXPECT_LT((viscous_on_spheres(spread) - viscous_on_spheres(by_throat)).norm(), 1e-12);
  EXPECT_GT(difference(spread.forces, by_throat.forces, 40, 1), .01);
}

TEST(ShearSpread, IsOfTheViscousForceAlone) {
  const Case problem = flow_through(random_with(1, 2));
  const auto by_throat = solved(problem, spreading(0)), spread = solved(problem, calibrated);
  for (std::size_t k = 0; k < spread.forces.pressure.size(); ++k)
    EXPECT_EQ(spread.forces.pressure[k], by_throat.forces.pressure[k]);
  EXPECT_EQ(shear_spread(HydraulicRadius{}), 0); // the paper's
}

/// The packing and its image beyond the upper face of an axis.
Packing with_image(const Packing& half, Axis axis) {
  Packing both = half;
  both.box.upper[index(axis)] *= 2; // the lower side is at 0
  for (Sphere sphere : half.spheres) {
    sphere.centre[index(axis)] = both.box.upper[index(axis)] - sphere.centre[index(axis)];
    both.spheres.push_back(sphere);
  }
  return both;
}

TEST(ShearSpread, FacesStandForWhatTheyMirror) {
  for (const double radius_ratio : {1.0, 2.0}) {
    const Packing half = random_with(4, radius_ratio);
    const auto beyond = [&](Axis axis, double share) {
      const auto alone = solved(flow_through(half), spreading(share));
      const auto doubled = solved(flow_through(with_image(half, axis)), spreading(share));
      return difference(alone.forces, doubled.forces, half.spheres.size(), axis == Axis::z ? 2 : 1);
    };
    EXPECT_LT(beyond(Axis::z, Calibrated{}.shear_spread), 5e-4); // where the pressure is imposed
    // Beside a slip wall a window of four spheres is cut along a diagonal, which by itself makes a difference.
    EXPECT_LT(beyond(Axis::x, Calibrated{}.shear_spread), beyond(Axis::x, 0));
  }
}

} // namespace
