// Conservation: what flows in flows out, and no force is lost.
#include "pfv/problem/generate.hpp"
#include "support/packings.hpp"

#include <gtest/gtest.h>

using namespace pfv;
using namespace pfv::testing;

namespace {

std::vector<Packing> packings() {
  return {packing_from("g200.txt"),
          packing_from("g2000.txt"),
          packing_from("bcc9.txt"),
          packing_from("bcc9jit.txt"),
          lattice_packing(Lattice::fcc, touching_solid_fraction(Lattice::fcc), 2),
          random_packing({.spheres = 80, .solid_fraction = .45, .radius_ratio = 4, .seed = 3, .size = 1})};
}

TEST(Balance, FluxInIsFluxOut) {
  for (const auto& packing : packings())
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
      const auto flow = solved(flow_through(packing, axis), {.solver = Cholmod{}});
      EXPECT_GT(flow.flux_in, 0);
      EXPECT_NEAR(flow.flux_out / flow.flux_in, 1, 1e-10);
    }
}

TEST(Balance, SpheresCarryThePressureDropAlongTheAxis) { // slip walls carry nothing along it
  for (const auto& packing : packings())
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
      const auto flow = solved(flow_through(packing, axis));
      const Vec3 size = packing.box.size();
      const double load = size.prod() / size[index(axis)];
      EXPECT_NEAR(force_on_spheres(flow)[index(axis)] / load, -1, 1e-10);
    }
}

TEST(Balance, SpheresAndWallsSumToZeroInEveryDirection) {
  for (const auto& packing : packings()) {
    const auto flow = solved(flow_through(packing, Axis::y));
    Vec3 sum = force_on_spheres(flow);
    for (const Vec3& force : flow.forces.on_face)
      sum += force;
    EXPECT_LT(sum.norm(), 1e-10);
  }
}

TEST(Balance, PressuresStayBetweenThoseOfTheFaces) {
  for (const auto& packing : packings()) {
    const auto flow = solved(flow_through(packing));
    for (const double p : flow.pressure) {
      EXPECT_GE(p, -1e-9);
      EXPECT_LE(p, 1 + 1e-9);
    }
  }
}

TEST(Balance, UniformPressureMakesNoFlowAndNoForce) {
  Case problem = flow_through(packing_from("g200.txt"));
  problem.faces[index(Face::z_min)] = Pressure{5};
  problem.faces[index(Face::z_max)] = Pressure{5};
  const auto flow = solved(problem);
  EXPECT_LT(flow.flux_in, 1e-15);
  for (std::size_t k = 0; k < flow.forces.pressure.size(); ++k)
    EXPECT_LT(flow.forces.of_flow(k).norm(), 1e-12);
}

TEST(Balance, BuoyancyIsTheWeightOfTheFluidDisplaced) {
  Case problem = flow_through(packing_from("g200.txt"));
  EXPECT_FALSE(solved(problem).forces.buoyancy.has_value());
  problem.buoyancy = Buoyancy{1000, {0, 0, -9.81}};
  const auto flow = solved(problem);
  Vec3 sum = Vec3::Zero();
  for (const Vec3& force : *flow.forces.buoyancy)
    sum += force;
  EXPECT_NEAR(sum.z(), 9810 * (1 - flow.network.porosity()), 1e-6);
  EXPECT_EQ(sum.x(), 0);
}

} // namespace
