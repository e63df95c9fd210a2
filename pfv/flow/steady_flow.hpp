#pragma once

#include "pfv/clock.hpp"
#include "pfv/flow/conductance.hpp"
#include "pfv/flow/flow_options.hpp"
#include "pfv/flow/flow_system.hpp"
#include "pfv/flow/fluid_forces.hpp"
#include "pfv/flow/shear_spread.hpp"
#include "pfv/pores/pore_network.hpp"
#include "pfv/problem/case.hpp"
#include "pfv/solvers/flow_solver.hpp"

#include <memory>
#include <optional>

namespace pfv {

struct SteadyFlow {
  PoreNetwork network;
  FlowSystem system;
  SolverReport solver;
  std::vector<double> pressure;      // Pa by pore
  std::size_t clamped_pores = 0;     // whose pressure was round-off beyond those imposed: set to the nearest of these
  std::array<double, 6> face_flux{}; // m^3/s, positive out of the box; through periodic faces, in and out again
  std::vector<double> point_flux;    // m^3/s, taken out at each pressure point
  double flux_in = 0;                // m^3/s, sum over faces and points where fluid enters
  double flux_out = 0;               // m^3/s, sum over faces and points where it leaves
  std::array<std::optional<double>, 6> pumped; // Pa, pressure of the Flux faces
  std::optional<Vec3> mean_flux;               // m/s, flux per area, in a periodic box
  std::optional<double> permeability;          // m^2, when the case is a permeability test
  FluidForces forces;

  /// What enters and does not leave, over the larger of the two; zero when nothing flows.
  double imbalance() const;
};

/// Steady flow through a fixed packing and its forces: stages `cells`, `triangulate`, `geometry`, `conductances`,
/// `assemble`, `factor`, `solve`, `forces`. The case must be valid. Throws InputError when the pressure has no level,
/// and SolveError.
SteadyFlow solve_steady_flow(const Case& problem, const FlowOptions& options, Clock& clock);

/// Steady flow through a packing whose spheres move: the first flow as solve_steady_flow gives it, the following ones
/// on the same pores and throats, with all that is measured on them anew, in place, and from the last pressures.
class FollowedFlow {
public:
  FollowedFlow(const Case& problem, const FlowOptions& options, Clock& clock);
  ~FollowedFlow();
  FollowedFlow(const FollowedFlow&) = delete;
  FollowedFlow& operator=(const FollowedFlow&) = delete;

  /// The flow where the spheres are now: stages `geometry`, `conductances`, `assemble`, `factor` (in whole only when
  /// throats open, close or contract), `solve`, `forces`. Right as long as `network.inverted_throats` stays zero; then
  /// the packing must be triangulated anew. The packing must have as many spheres as before. Throws SolveError.
  void follow(const Packing& packing, Clock& clock);

  const SteadyFlow& flow() const { return flow_; }

private:
  friend SteadyFlow solve_steady_flow(const Case& problem, const FlowOptions& options, Clock& clock);

  struct WithoutForces {};
  FollowedFlow(WithoutForces tag, const Case& problem, const FlowOptions& options, Clock& clock);

  void factor(Clock& clock);
  void solve(Clock& clock);
  void find_forces(Clock& clock);

  Case question_; // without its spheres
  FlowOptions options_;
  SteadyFlow flow_;
  Conductances throats_; // room for the next ones
  std::unique_ptr<FlowSolver> solver_;
  Eigen::VectorXd solution_;
  ShearSpread spread_shear_;
};

} // namespace pfv
