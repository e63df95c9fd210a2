#pragma once

#include "pfv/clock.hpp"
#include "pfv/flow/conductance.hpp"
#include "pfv/flow/flow_solver.hpp"
#include "pfv/flow/flow_system.hpp"
#include "pfv/flow/fluid_forces.hpp"
#include "pfv/pores/pore_network.hpp"
#include "pfv/problem/case.hpp"

#include <optional>

namespace pfv {

/// How the pore-scale finite volumes answer, apart from what the case asks.
struct FlowOptions {
  Conductance conductance = HydraulicRadius{};
  WallRule walls = MirrorWalls{};
  SolverChoice solver = AutoSolver{};
};

struct SteadyFlow {
  PoreNetwork network;
  FlowSystem system;
  SolverReport solver;
  std::vector<double> pressure;       // Pa by pore
  std::array<double, 6> face_flux{};  // m^3/s, positive out of the box
  double flux_in = 0;                 // m^3/s, sum over the faces where fluid enters
  double flux_out = 0;                // m^3/s, sum over the faces where it leaves
  std::optional<double> permeability; // m^2, when the case is a permeability test
  FluidForces forces;
};

/// Steady flow through a fixed packing and its forces: stages `triangulate`, `geometry`, `conductances`, `assemble`,
/// `factor`, `solve`, `forces`. The case must be valid. Throws InputError without a Pressure
/// face, and SolveError.
SteadyFlow solve_steady_flow(const Case& problem, const FlowOptions& options, Clock& clock);

} // namespace pfv
