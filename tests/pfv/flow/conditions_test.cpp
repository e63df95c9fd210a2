// Imposed fluxes, pressure profiles and pressures at points: each against a flow that must be the same.
#include "pfv/flow/containing_pore.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "support/message_of.hpp"
#include "support/packings.hpp"

#include <gtest/gtest.h>

using namespace pfv;
using namespace pfv::testing;

namespace {

Case problem_with(Face face, const FaceCondition& condition, const char* file = "g200.txt") {
  Case problem = flow_through(packing_from(file));
  problem.faces[index(face)] = condition;
  return problem;
}

void expect_same_pressures(const SteadyFlow& one, const SteadyFlow& other, double tolerance) {
  ASSERT_EQ(one.pressure.size(), other.pressure.size());
  for (std::size_t i = 0; i < one.pressure.size(); ++i)
    ASSERT_NEAR(one.pressure[i], other.pressure[i], tolerance) << i;
}

TEST(FluxFace, WithTheFluxOfAPressureRunGivesItsPressures) {
  for (const char* file : {"g200.txt", "bcc9.txt"}) {
    const auto driven = solved(flow_through(packing_from(file)));
    const double flux = -driven.face_flux[index(Face::z_max)]; // into the box
    const auto pumped = solved(problem_with(Face::z_max, Flux{flux}, file));
    expect_same_pressures(pumped, driven, 1e-9);
    EXPECT_NEAR(pumped.pumped[index(Face::z_max)].value(), 1, 1e-9);
    EXPECT_FALSE(pumped.pumped[index(Face::z_min)]);
    EXPECT_NEAR(-pumped.face_flux[index(Face::z_max)] / flux, 1, 1e-9);
    EXPECT_NEAR(*pumped.permeability / *driven.permeability, 1, 1e-9);
    EXPECT_NEAR(force_on_spheres(pumped).z(), force_on_spheres(driven).z(), 1e-8);
  }
}

TEST(FluxFace, OnEachOfTwoFacesPassesItsOwn) {
  Case problem = flow_through(lattice_packing(Lattice::bcc, 0.5, 3));
  problem.faces = {Flux{2e-3}, Flux{-5e-4}, SlipWall{}, SlipWall{}, SlipWall{}, SlipWall{}};
  problem.pressure_points = {{Vec3(1.6, 1.4, 1.5), 7}};
  const auto flow = solved(problem);
  EXPECT_NEAR(flow.face_flux[0], -2e-3, 1e-12);
  EXPECT_NEAR(flow.face_flux[1], 5e-4, 1e-12);
  EXPECT_NEAR(flow.point_flux[0], 1.5e-3, 1e-12);
  EXPECT_LT(flow.imbalance(), 1e-9);
}

TEST(FluxFace, OneLayerHasNoUnknownsButAPressure) {
  Case problem = flow_through(lattice_packing(Lattice::simple_cubic, 0.5, 1));
  const double k = *solved(problem).permeability;
  problem.faces[index(Face::z_max)] = Flux{-3};
  EXPECT_NEAR(*solved(problem).permeability / k, 1, 1e-12);
}

TEST(FluxFace, ThatMeetsAKnownPressureIsRefused) {
  EXPECT_EQ(message_of<SolveError>([] { solved(problem_with(Face::x_max, Flux{1})); }),
            "x_max (flux 1 m^3/s) and z_min (0 Pa) meet in one pore: they must have the same pressure");
}

TEST(PressureProfile, ThatIsConstantEqualsAPressure) {
  const PressureProfile one{Axis::x, {{0.2, 1}, {0.4, 1}}};
  const auto pressure = solved(problem_with(Face::z_max, one)).pressure;
  const auto expected = solved(flow_through(packing_from("g200.txt"))).pressure;
  ASSERT_EQ(pressure.size(), expected.size());
  for (std::size_t i = 0; i < pressure.size(); ++i)
    EXPECT_NEAR(pressure[i], expected[i], 1e-9);
}

TEST(PressureProfile, AroundTheBoxMakesNoPoreDifferFromIt) {
  // p = 1 + 2 x on all faces across y and z, and what that means on those across x.
  const PressureProfile linear{Axis::x, {{0, 1}, {1, 3}}};
  Case problem = flow_through(packing_from("g200.txt"));
  problem.faces = {Pressure{1}, Pressure{3}, linear, linear, linear, linear};
  const auto flow = solved(problem);
  for (const auto& part : flow.network.wall_parts)
    EXPECT_NEAR(flow.pressure[part.pore], 1 + 2 * flow.network.pores.centre[part.pore].x(), 1e-9);
  for (const double p : flow.pressure) {
    EXPECT_GE(p, 1 - 1e-9);
    EXPECT_LE(p, 3 + 1e-9);
  }
  EXPECT_FALSE(flow.permeability);
  EXPECT_LT(flow.imbalance(), 1e-9);
}

TEST(PressureProfile, Superposes) {
  const auto flow = [](double left, double right) {
    return solved(problem_with(Face::z_max, PressureProfile{Axis::y, {{0.1, left}, {0.9, right}}}));
  };
  const auto one = flow(1, 0), other = flow(0, 1), both = flow(3, -2);
  for (std::size_t i = 0; i < both.pressure.size(); ++i)
    ASSERT_NEAR(both.pressure[i], 3 * one.pressure[i] - 2 * other.pressure[i], 3e-9); // each solved to 1e-10
}

TEST(ContainingPore, HoldsTheMeanOfItsCorners) {
  const Packing packing = packing_from("g200.txt");
  Clock clock;
  const PoreNetwork network = build_pore_network(packing, {}, clock);
  int tested = 0;
  for (std::size_t i = 0; i < network.pores.size(); ++i) {
    const auto& corners = network.pores.vertices[i];
    if (std::ranges::any_of(corners, is_wall))
      continue;
    Vec3 middle = Vec3::Zero();
    for (const Vertex v : corners)
      middle += network.sites.spheres[v].centre / 4;
    EXPECT_EQ(containing_pore(network, middle).pore, static_cast<int>(i));
    ++tested;
  }
  EXPECT_GT(tested, 300);
  for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(1, 0, 1), Vec3(1, 1, 1)}) {
    const auto pore = static_cast<std::size_t>(containing_pore(network, corner).pore);
    EXPECT_TRUE(network.pores.touches(pore, corner.x() > 0 ? Face::x_max : Face::x_min));
    EXPECT_TRUE(network.pores.touches(pore, corner.z() > 0 ? Face::z_max : Face::z_min));
  }
}

TEST(PressurePoint, Holds) {
  Case problem = flow_through(packing_from("g200.txt"));
  problem.pressure_points = {{Vec3(0.5, 0.5, 0.5), 4}, {Vec3(0.2, 0.3, 0.6), -1}};
  const auto flow = solved(problem);
  for (const auto& point : problem.pressure_points)
    EXPECT_EQ(flow.pressure[containing_pore(flow.network, point.position).pore], point.value);
  EXPECT_LT(flow.point_flux[0], 0) << "a source";
  EXPECT_GT(flow.point_flux[1], 0) << "a sink";
  EXPECT_FALSE(flow.permeability);
  EXPECT_LT(flow.imbalance(), 1e-9);
}

TEST(PressurePoint, AtThePressureThatIsThereAnywayChangesNothing) {
  Case problem = flow_through(packing_from("g200.txt"));
  const auto plain = solved(problem);
  const Vec3 middle(0.5, 0.5, 0.5);
  problem.pressure_points = {{middle, plain.pressure[containing_pore(plain.network, middle).pore]}};
  const auto flow = solved(problem);
  expect_same_pressures(flow, plain, 1e-9);
  EXPECT_NEAR(flow.point_flux[0] / flow.flux_in, 0, 1e-9);
}

TEST(PressurePoint, GivesTheLevelAlone) {
  Case problem = flow_through(packing_from("g200.txt"));
  problem.faces = {};
  problem.pressure_points = {{Vec3(0.5, 0.5, 0.5), 4}};
  const auto flow = solved(problem);
  for (const double p : flow.pressure)
    EXPECT_NEAR(p, 4, 1e-9);
  EXPECT_EQ(flow.system.isolated_pores, 0u);
}

TEST(PressurePoint, OfAnotherPressureInTheSamePoreIsRefused) {
  Case problem = flow_through(packing_from("g200.txt"));
  problem.pressure_points = {{Vec3(0.5, 0.5, 0.5), 4}, {Vec3(0.5, 0.5, 0.5), 5}};
  EXPECT_EQ(message_of<SolveError>([&] { solved(problem); }),
            "pressure point 0 (4 Pa) and pressure point 1 (5 Pa) meet in one pore: they must have the same pressure");
}

} // namespace
