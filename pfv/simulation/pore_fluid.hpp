#pragma once

#include "pfv/clock.hpp"
#include "pfv/flow/conductance.hpp"
#include "pfv/flow/flow_options.hpp"
#include "pfv/flow/flow_system.hpp"
#include "pfv/problem/case.hpp"
#include "pfv/simulation/neighbour_drift.hpp"
#include "pfv/simulation/pressure_solver.hpp"
#include "pfv/simulation/solid_flux.hpp"

#include <optional>

namespace pfv {

/// A fluid that gives way: dp/dt = - bulk_modulus / V_void times the volume that enters.
struct CompressibleFluid {
  double bulk_modulus; // Pa

  bool operator==(const CompressibleFluid&) const = default;
};

struct FluidScene {
  Fluid fluid;
  FaceConditions faces{};
  PressuresInTime in_time{}; // where there is one, the face is a Pressure
  std::vector<PressurePoint> pressure_points;
  FlowOptions options;
  std::optional<CompressibleFluid> compressible;
  // Of pressures, in the norm of the dissipated power. Measured on the layer of `studies/speed`: settlement is off by
  // 2e-6, less than by any renewal of conductances, and a semi-implicit step takes 2 iterations for the 7 of 1e-6.
  double tolerance = 1e-4;
  // Of the mean radius: how far neighbours part before conductances are renewed, and before they are triangulated anew.
  // Measured: 0.01 changes a settlement by 3e-4 at most, 0.03 by 1e-3.
  double refresh_drift = 0.01, rebuild_drift = 0.05;
};

/// The scene with the pressures its faces have at a time (s).
FluidScene at_time(FluidScene scene, double time);

/// What a fluid remembers of what has been, in pores that are triangulated anew.
struct FluidState {
  struct Counts {
    std::size_t refreshed, rebuilt, iterations, solves;
  };
  std::vector<double> above_level; // Pa, the unknown pressures
  double level = 0;                // Pa
  Counts counts{};
};

/// The fluid between grains that move: continuity in every pore, A p = - B v, as of eq. (10) of Catalano et al. 2011
/// with SolidFlux for the rates of volume, and the forces B^T p.
///
/// Stages `cells`, `triangulate`, `geometry`, `conductances`, `assemble` as of solve_steady_flow, `volume rates`,
/// `solve` and `forces`. A network is followed as grains move and built anew when they have moved too far or a facet
/// has turned around; pressures are carried over.
class PoreFluid {
public:
  /// In a steady flow; a fluid that no imposed pressure reaches is at the mean of these, or at zero without any. Throws
  /// InputError when nothing sets the level of the pressures: neither a face or point nor storage.
  PoreFluid(const FluidScene& scene, const Packing& packing, Clock& clock);
  PoreFluid(const PoreFluid&) = delete; // the solver points to the matrices
  PoreFluid& operator=(const PoreFluid&) = delete;

  /// Renews the pores if grains have moved; nothing otherwise. Along periodic axes grains may have left the box.
  void follow(const Packing& packing, Clock& clock);

  /// Triangulates anew, as `follow` does when grains have moved far: the pores then depend on nothing but where grains
  /// are, so a fluid made there and given the state goes on alike.
  void renew(const Packing& packing, Clock& clock);
  FluidState state() const;
  /// Throws InputError when the state is of other pores.
  void restore(const FluidState& state);

  /// Imposes the pressures that faces have at a time (s).
  void impose_at(double time);

  /// Forces (N) on all bodies. Explicit when `per_mass` is empty: A p = - B v with the velocities (m/s) as they are.
  /// Semi-implicit otherwise: p such that the velocities after the step, v + step F / mass, satisfy it, which is
  /// (A + step B M^-1 B^T) p = - B v. `per_mass` is 1 / mass by body, zero where the motion is prescribed.
  const std::vector<Vec3>& forces(std::span<const Vec3> velocity, std::span<const double> per_mass, double step,
                                  Clock& clock);

  /// Largest eigenvalue (1/s) of M^-1 B A^-1 B^T: an explicit step longer than 2 / it is unstable. What a compressible
  /// fluid stores, S by pore, stiffens the shorter the step: with A + 2 S / step in the place of A the same holds of
  /// all steps up to `longest` (s).
  double largest_rate(std::span<const double> per_mass, double longest, Clock& clock);

  const PoreNetwork& network() const { return network_; }
  const FlowSystem& system() const { return system_; }
  const SolidFlux& flux() const { return flux_; }
  const std::vector<double>& pressure() const { return pressure_; } // Pa, by pore
  /// Pa, over the fluid.
  double mean_pressure() const;
  /// J/s, of the imposed pressures, each times the fluid that enters where it is, after the last solution and with
  /// bodies that move at these velocities (m/s).
  double inflow_power(std::span<const Vec3> velocity);
  /// J/s, dissipated by the flow between pores in the last solution.
  double dissipation() const;

  std::size_t refreshed = 0, rebuilt = 0, iterations = 0, solves = 0;

private:
  void build(const Packing& packing, Clock& clock);
  void start_in_steady_flow();
  void start_from(const std::vector<double>& pressure);
  void keep_mean(double pressure);
  void balance_all_together();
  void start_from_solution();
  Packing in_box(const Packing& packing) const;
  void assemble_anew(Clock& clock);
  bool refresh_system(Clock& clock);
  void set_flux();
  void set_known_force();
  const FlowMatrix& with_storage(double step, FlowMatrix& room) const;
  void set_matrix(std::span<const double> per_mass, double step);
  void add_to_unknowns(const std::vector<double>& of_pores, Eigen::VectorXd& sum) const;

  FluidScene scene_;
  PoreNetwork network_;
  Conductances throats_;
  FlowSystem system_;
  SolidFlux flux_;
  std::vector<Vec3> known_force_; // N, of the pressures that are known
  bool drives_ = false;           // whether any pressure that is imposed is not zero
  Eigen::VectorXd storage_;       // m^3/Pa by unknown, of a compressible fluid
  Eigen::VectorXd of_uniform_;    // m^3/(Pa s) by unknown, what a step does of a uniform pressure; likewise

  bool matrix_is_set_ = false; // for this step:
  double of_step_ = 0;         // s
  FlowMatrix stored_;          // the system's matrix with the storage of the fluid; unused when it is incompressible
  GramTerm solid_;             // empty when the fluid is explicit
  PressureSolver solver_;
  PastIncrements increments_;

  std::vector<double> pressure_;
  Eigen::VectorXd solution_;
  Eigen::VectorXd mode_; // of the largest rate
  NeighbourDrift since_built_, since_refreshed_;
  std::vector<Vec3>
      into_box_; // m, from where a grain was when triangulated to its image in the box; empty if not periodic
  double mean_radius_ = 0;

  // Room for a step.
  std::vector<double> rate_;
  Eigen::VectorXd right_side_;
  std::vector<Vec3> force_, moving_, of_block_;
};

} // namespace pfv
