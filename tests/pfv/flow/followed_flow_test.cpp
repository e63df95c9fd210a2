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
    EXPECT_EQ(names(next), (std::vector<std::string>{"geometry", "conductances", "assemble", "solve", "forces"}));
  }
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
