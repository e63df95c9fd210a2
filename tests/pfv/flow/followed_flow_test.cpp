// The flow through spheres that move a little, against the flow through the same spheres from scratch.
#include "pfv/problem/generate.hpp"
#include "support/packings.hpp"

#include <gtest/gtest.h>
#include <random>

using namespace pfv;
using namespace pfv::testing;

namespace {

Packing moved(Packing packing, double by) {
  std::mt19937 random(3);
  for (auto& sphere : packing.spheres)
    for (double& x : sphere.centre)
      x += by * sphere.radius * std::uniform_real_distribution(-1., 1.)(random);
  return packing;
}

std::vector<std::string> names(const Clock& clock) {
  std::vector<std::string> result;
  for (const Stage& stage : clock.stages())
    result.push_back(stage.name);
  return result;
}

TEST(FollowedFlow, IsTheFlowThroughTheMovedSpheres) {
  for (const PeriodicAxes periodic : {PeriodicAxes{}, PeriodicAxes{true, true, true}}) {
    Case problem;
    problem.packing =
        random_packing({.spheres = 300, .solid_fraction = .45, .radius_ratio = 2, .seed = 6, .periodic = periodic});
    problem.faces = flow_along(Axis::z, 1, periodic, problem.packing.box);
    Clock first, next;
    FollowedFlow followed(problem, {}, first);
    problem.packing = moved(problem.packing, 1e-5);
    followed.follow(problem.packing, next);
    const SteadyFlow anew = solved(problem);
    ASSERT_EQ(followed.flow().network.inverted_throats, 0u);
    EXPECT_NEAR(*followed.flow().permeability / *anew.permeability, 1, 1e-7);
    for (std::size_t k = 0; k < problem.packing.spheres.size(); ++k)
      EXPECT_LT((followed.flow().forces.of_flow(k) - anew.forces.of_flow(k)).norm(), 1e-7) << k;
    EXPECT_EQ(names(next),
              (std::vector<std::string>{"geometry", "conductances", "assemble", "factor", "solve", "forces"}));
    EXPECT_EQ(followed.flow().solver.refactored, 0); // the old factor, brought up to date
  }
}

TEST(FollowedFlow, NeedsNoShapesOnceThereAreConductances) {
  for (const Conductance& rule : {Conductance{HydraulicRadius{}}, Conductance{Calibrated{}}}) {
    Case problem = flow_through(packing_from("g200.txt"));
    Clock clock;
    FollowedFlow keeps(problem, {.conductance = rule}, clock);
    FollowedFlow forgets(problem, {.conductance = rule, .keep_shapes = false}, clock);
    const auto& throats = forgets.flow().network.throats;
    EXPECT_EQ(throats.fluid_area.capacity() + throats.length.capacity() + throats.void_volume.capacity() +
                  throats.area.capacity() + throats.gap.capacity() + throats.contrast.capacity(),
              0u);
    for (int step = 0; step < 2; ++step) {
      EXPECT_EQ(forgets.flow().permeability, keeps.flow().permeability);
      problem.packing = moved(problem.packing, 1e-4);
      keeps.follow(problem.packing, clock);
      forgets.follow(problem.packing, clock);
    }
    EXPECT_EQ(forgets.flow().pressure, keeps.flow().pressure);
    EXPECT_EQ(throats.gap, keeps.flow().network.throats.gap);
  }
}

/// The original implementation keeps the conductances of its first flow while spheres move, so all its pressures:
/// forces then change only as throats do.
TEST(FollowedFlow, IsNearerToTheTruthAtALooseToleranceThanFrozenConductancesAre) {
  Case problem = flow_through(packing_from("g2000.txt"));
  Clock clock;
  FollowedFlow loose(problem, {.solver = Multigrid{1e-6}}, clock);
  const std::vector<double> frozen_pressure = FollowedFlow(problem, {}, clock).flow().pressure;
  problem.packing = moved(problem.packing, 1e-5);
  loose.follow(problem.packing, clock);
  const SteadyFlow truth = solved(problem);
  const FluidForces frozen = fluid_forces(truth.network, truth.system, frozen_pressure, MirrorWalls{}, {});
  double of_loose = 0, of_frozen = 0;
  for (std::size_t k = 0; k < problem.packing.spheres.size(); ++k) {
    of_loose += (loose.flow().forces.of_flow(k) - truth.forces.of_flow(k)).squaredNorm();
    of_frozen += (frozen.of_flow(k) - truth.forces.of_flow(k)).squaredNorm();
  }
  EXPECT_LT(of_loose, .25 * of_frozen); // squares
  EXPECT_LE(loose.flow().solver.iterations, 3);
}

TEST(FollowedFlow, TakesFewerStepsThanTheFirst) {
  const Case problem = flow_through(packing_from("g2000.txt"));
  Clock clock;
  FollowedFlow followed(problem, {.solver = Multigrid{}}, clock);
  const int first = followed.flow().solver.iterations;
  followed.follow(problem.packing, clock);
  EXPECT_LE(followed.flow().solver.iterations, first / 4);
  EXPECT_EQ(followed.flow().solver.refactored, 0);
}

TEST(NoSlipWalls, TakeWhatTheSpheresDoNot) {
  const Case problem = flow_through(packing_from("g200.txt"));
  const SteadyFlow slip = solved(problem), stick = solved(problem, {.walls = NoSlipWalls{}});
  EXPECT_LT(*stick.permeability, .98 * *slip.permeability);
  const auto on_sides = [](const SteadyFlow& flow) {
    double sum = 0;
    for (const Face face : {Face::x_min, Face::x_max, Face::y_min, Face::y_max})
      sum += flow.forces.on_face[index(face)].z();
    return sum;
  };
  EXPECT_NEAR(on_sides(slip), 0, 1e-12);
  EXPECT_LT(on_sides(stick), -.01); // down the pressure
  EXPECT_NEAR(force_on_spheres(stick).z() + on_sides(stick), -1, 1e-8);
}

} // namespace
