#include "pfv/simulation/solid_flux.hpp"

#include "pfv/flow/steady_flow.hpp"
#include "pfv/problem/generate.hpp"

#include <gtest/gtest.h>

#include <numeric>

using namespace pfv;

namespace {

Case random_case(double ratio) {
  Case problem;
  problem.packing = random_packing({.spheres = 150, .solid_fraction = 0.5, .radius_ratio = ratio, .seed = 4});
  problem.faces = flow_along(Axis::z, 3.0);
  return problem;
}

Vec3 wiggle(std::size_t k) {
  const auto x = static_cast<double>(k);
  return {std::sin(1 + x), std::sin(2 + 3 * x), std::sin(3 + 7 * x)};
}

/// Walls move along their normals only.
std::vector<Vec3> velocities(std::size_t bodies, const std::function<Vec3(std::size_t)>& of) {
  std::vector<Vec3> velocity(bodies);
  for (std::size_t k = 0; k < bodies; ++k)
    velocity[k] = of(k);
  for (const Face face : all_faces) {
    Vec3& wall = velocity[bodies - 6 + index(face)];
    wall = wall.cwiseProduct(outward_normal(face).cwiseAbs());
  }
  return velocity;
}

TEST(SolidFlux, IsZeroWhenEverythingMovesTogether) {
  for (const double ratio : {1.0, 5.0, 20.0}) {
    Clock clock;
    const PoreNetwork network = build_pore_network(random_case(ratio).packing, {}, clock);
    const SolidFlux flux = solid_flux(network, MirrorWalls{});
    std::vector<double> rate;
    volume_rates(flux, velocities(flux.bodies, [](std::size_t) { return Vec3(1, -2, 3); }), rate);
    for (const double of_pore : rate)
      EXPECT_NEAR(of_pore, 0, 1e-12);
  }
}

TEST(SolidFlux, SumsToTheVolumeThatWallsSweep) {
  Clock clock;
  const PoreNetwork network = build_pore_network(random_case(3).packing, {}, clock);
  const SolidFlux flux = solid_flux(network, MirrorWalls{});
  std::vector<double> rate;
  const auto velocity = velocities(flux.bodies, wiggle);
  volume_rates(flux, velocity, rate);
  double swept = 0; // of the unit cube
  for (const Face face : all_faces)
    swept += outward_normal(face).dot(velocity[flux.bodies - 6 + index(face)]);
  EXPECT_NEAR(std::reduce(rate.begin(), rate.end()), swept, 1e-12);
}

TEST(SolidFlux, PushesAsTheFluidForces) {
  const Case problem = random_case(5);
  Clock clock;
  const SteadyFlow flow = solve_steady_flow(problem, {}, clock);
  const SolidFlux flux = solid_flux(flow.network, MirrorWalls{});
  std::vector<Vec3> force;
  pressure_forces(flux, flow.pressure, force);
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < flux.bodies; ++k) {
    const std::size_t spheres = flux.bodies - 6;
    const Vec3 expected = k < spheres ? flow.forces.of_flow(k) : flow.forces.on_face[k - spheres];
    EXPECT_LT((force[k] - expected).norm(), 1e-12) << k;
    sum += force[k];
  }
  EXPECT_LT(sum.norm(), 1e-11);
}

TEST(SolidFlux, LetsTheFluidOnlyTakeEnergyAtAnySizeRatio) {
  for (const double ratio : {1.0, 5.0, 20.0}) {
    Case problem = random_case(ratio);
    problem.faces = flow_along(Axis::z, 0.0);
    Clock clock;
    const PoreNetwork network = build_pore_network(problem.packing, {}, clock);
    const FlowSystem system = assemble(
        network, conductances(network, HydraulicRadius{}, MirrorWalls{}, problem.fluid.viscosity), problem.faces);
    const SolidFlux flux = solid_flux(network, MirrorWalls{});
    const auto solver = make_solver(Cholmod{});
    solver->analyse(system.matrix);
    solver->factor(system.matrix);
    for (std::size_t sample = 0; sample < 40; ++sample) {
      const auto velocity = velocities(flux.bodies, [&](std::size_t k) { return wiggle(k * (sample + 1) + sample); });
      std::vector<double> rate;
      volume_rates(flux, velocity, rate);
      Eigen::VectorXd right = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(system.unknowns())), pressure;
      for (std::size_t i = 0; i < rate.size(); ++i)
        if (system.unknown_of_pore[i] >= 0)
          right[system.unknown_of_pore[i]] -= rate[i];
      solver->solve(right, pressure);
      std::vector<Vec3> force;
      pressure_forces(flux, pore_pressures(system, pressure), force);
      double power = 0, dissipated = pressure.dot(system.matrix * pressure);
      for (std::size_t k = 0; k < flux.bodies; ++k)
        power += force[k].dot(velocity[k]);
      EXPECT_GT(dissipated, 0);
      EXPECT_NEAR(power / dissipated, -1, 1e-9);
    }
  }
}

} // namespace
