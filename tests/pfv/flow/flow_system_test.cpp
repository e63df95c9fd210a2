#include "pfv/flow/flow_system.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "support/message_of.hpp"
#include "support/packings.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>
#include <limits>

using namespace pfv;
using namespace pfv::testing;

namespace {

TEST(FlowSystem, IsPositiveDefinite) {
  for (const char* file : {"bcc9.txt", "bcc9jit.txt", "g200.txt"}) {
    const auto system = solved(flow_through(packing_from(file))).system;
    const Eigen::MatrixXd dense = system.matrix;
    EXPECT_EQ((dense - dense.transpose()).norm(), 0) << file;
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense).eigenvalues().minCoeff(), 0) << file;
  }
}

TEST(FlowSystem, ContractsTheCoincidentPoresOfALattice) {
  const auto flow =
      solved(flow_through(lattice_packing(Lattice::simple_cubic, touching_solid_fraction(Lattice::simple_cubic), 3)));
  EXPECT_GT(flow.system.contracted_throats, 0u);
  // Without splits: pores at the 4 x 4 x 4 corners of the cells, of which the two outer layers along z are known.
  EXPECT_EQ(flow.system.unknowns(), 4u * 4 * 2);
}

TEST(FlowSystem, ContractsNothingInARandomPacking) {
  EXPECT_EQ(solved(flow_through(packing_from("g200.txt"))).system.contracted_throats, 0u);
}

TEST(FlowSystem, OneLayerLeavesNothingUnknown) {
  const auto flow = solved(flow_through(lattice_packing(Lattice::simple_cubic, 0.5, 1)));
  EXPECT_EQ(flow.system.unknowns(), 0u);
  EXPECT_GT(*flow.permeability, 0);
}

TEST(FlowSystem, RefusesDifferentPressuresThatMeet) {
  Case problem = flow_through(packing_from("g200.txt"));
  problem.faces[index(Face::x_min)] = Pressure{3};
  EXPECT_NE(message_of<SolveError>([&] { solved(problem); }).find("x_min (3 Pa) and z_m"), std::string::npos);
}

TEST(FlowSystem, NeedsAPressure) {
  Case problem = flow_through(packing_from("bcc9.txt"));
  problem.faces = {};
  EXPECT_THROW(solved(problem), InputError);
}

TEST(FlowSystem, OfASealedBoxHasNoUnknownButThoseThatStorageSets) {
  Clock clock;
  const PoreNetwork network = build_pore_network(packing_from("g200.txt"), {}, clock);
  const Conductances throats = conductances(network, HydraulicRadius{}, MirrorWalls{}, 1);
  const FlowSystem at_mean = assemble(network, throats, {});
  EXPECT_EQ(at_mean.unknowns(), 0u);
  EXPECT_EQ(at_mean.isolated_pores, network.pores.size());
  const FlowSystem unknown = assemble(network, throats, {}, {}, Isolated::unknown);
  EXPECT_EQ(unknown.unknowns(), network.pores.size());
  EXPECT_EQ(unknown.isolated_pores, 0u);
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(unknown.matrix.rows());
  EXPECT_LT((unknown.matrix * one).norm(), 1e-12 * unknown.matrix.norm()); // a uniform pressure moves nothing
}

TEST(FlowSystem, WorksWithOneFaceAtAPressure) {
  Case problem = flow_through(packing_from("bcc9jit.txt"));
  problem.faces[index(Face::z_min)] = SlipWall{};
  const auto flow = solved(problem);
  EXPECT_FALSE(flow.permeability.has_value());
  EXPECT_LT(flow.flux_in, 1e-13);
}

TEST(FlowSystem, RefreshesInPlace) {
  Packing packing = packing_from("g200.txt");
  FaceConditions faces = flow_along(Axis::z);
  faces[index(Face::z_max)] = PressureProfile{Axis::x, {{0, 1}, {1, 2}}};
  Clock clock;
  PoreNetwork network = build_pore_network(packing, {}, clock);
  Conductances k = conductances(network, HydraulicRadius{}, MirrorWalls{}, 1);
  FlowSystem system = assemble(network, k, faces);
  for (Sphere& sphere : packing.spheres)
    sphere.radius *= 0.999;
  follow(network, packing, clock);
  update(k, network, MixedArea{}, MirrorWalls{}, 1);
  const double* values = system.matrix.valuePtr();
  ASSERT_TRUE(refresh(system, network, k));
  const FlowSystem fresh = assemble(network, k, faces);
  EXPECT_EQ(system.matrix.valuePtr(), values);
  EXPECT_LT(Eigen::MatrixXd(system.matrix - fresh.matrix).norm(), 1e-14 * fresh.matrix.norm());
  EXPECT_LT((system.right_side - fresh.right_side).norm(), 1e-14 * fresh.right_side.norm());
  EXPECT_EQ(pore_pressures(system, system.right_side), pore_pressures(fresh, system.right_side));
}

TEST(FlowSystem, DoesNotRefreshAnotherPattern) {
  Clock clock;
  const PoreNetwork network = build_pore_network(packing_from("g200.txt"), {}, clock);
  Conductances k = conductances(network, HydraulicRadius{}, MirrorWalls{}, 1);
  FlowSystem system = assemble(network, k, flow_along(Axis::z));
  k.values[7] = std::numeric_limits<double>::infinity(); // for a moment, as at a flip
  EXPECT_TRUE(refresh(system, network, k));
  EXPECT_TRUE(std::isfinite(system.conductance[7]));
  k.values[7] = 0;
  EXPECT_FALSE(refresh(system, network, k));
}

TEST(FlowSystem, TimesItsStagesInOrder) {
  Clock clock;
  solve_steady_flow(flow_through(packing_from("bcc9.txt")), {}, clock);
  std::vector<std::string> names;
  for (const auto& stage : clock.stages())
    names.push_back(stage.name);
  EXPECT_EQ(names, (std::vector<std::string>{"cells", "triangulate", "geometry", "conductances", "assemble", "factor",
                                             "solve", "forces"}));
}

} // namespace
