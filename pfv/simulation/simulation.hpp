#pragma once

#include "pfv/simulation/checkpoint.hpp"
#include "pfv/simulation/grain_cycle.hpp"
#include "pfv/simulation/pore_fluid.hpp"

#include <string_view>
#include <variant>

namespace pfv {

// How the fluid's force enters a step.

/// With the velocities of half a step before: cheap, and stable below a limit that the viscosity sets.
struct Explicit {
  static constexpr std::string_view name = "explicit";
  bool operator==(const Explicit&) const = default;
};

/// With the velocities after it: the fluid limits no step.
struct SemiImplicit {
  static constexpr std::string_view name = "semi-implicit";
  bool operator==(const SemiImplicit&) const = default;
};

using TimeScheme = std::variant<Explicit, SemiImplicit>;

/// A packing in motion, with fluid or without.
struct Scene {
  std::string name;
  Packing packing;
  GrainScene grains;
  std::optional<FluidScene> fluid;
  TimeScheme scheme;
  std::optional<double> step;          // s; from the limits when absent
  std::vector<std::string> notes = {}; // of the reader of its packing
};

/// Throws InputError when radii are to grow in a fluid or films, which do not follow them, or between loaded walls,
/// which have a stress of their own to keep.
void require_growth_alone(const Scene& scene);

/// The longest stable steps (s).
struct StepLimits {
  double contact;                      // of contacts alone
  std::optional<double> viscous{};     // of an explicit fluid alone
  std::optional<double> lubrication{}; // of the films alone
  /// Of all together: leapfrog with lagging dampers is stable while w^2 step^2 + 2 c step < 4, c being the sum of
  /// rates.
  double joint() const;
  /// The step that is taken: 0.3 of the contacts' limit, as friction and collisions want some twenty steps, 0.8 of the
  /// fluid's and of the films', joined like the limits.
  double chosen() const;
};

/// Of dry grains as they are now.
StepLimits limits_of(const GrainCycle& cycle);

/// The cycle of Catalano et al. 2011, figure 3: contacts, rates of volume, flow, forces of the fluid, motion. A dry
/// scene has no pores, no matrix and none of the stages of a flow.
class Simulation {
public:
  explicit Simulation(const Scene& scene);
  /// Goes on from grains as another run left them, springs included; the scene's own packing is not used.
  Simulation(const Scene& scene, GrainCycle start);
  /// Goes on as the run that was saved does, bit for bit when the scene is the same. Where only this one has a fluid,
  /// that starts in a steady flow. Throws InputError when the checkpoint is of other grains.
  Simulation(const Scene& scene, const Checkpoint& from);

  /// One step of `step()` seconds. Throws SolveError naming the limit when the run has left stability.
  void advance();

  /// What is needed to go on from here. Pores, candidates and step are found anew, as they are by who goes on from it.
  /// Throws SolveError when the run has left stability, so that it does not take the place of a sound one.
  Checkpoint checkpoint();

  const StepLimits& limits() const { return limits_; }
  double step() const { return step_; }
  const GrainCycle& grains() const { return cycle_; }
  const std::optional<PoreFluid>& fluid() const { return fluid_; }
  const Clock& clock() const { return clock_; }
  std::size_t steps() const { return steps_; }
  /// Force of the fluid on bodies (N) in the last step; empty when dry.
  std::span<const Vec3> fluid_forces() const { return fluid_force_; }

private:
  void choose_step();
  void advance_with_fluid();
  void check_stability();
  std::vector<Vec3> body_velocities() const;

  Scene scene_; // without its packing
  Clock clock_;
  GrainCycle cycle_;
  std::optional<PoreFluid> fluid_;
  std::vector<double> per_mass_; // 1/kg, by body
  std::vector<Vec3> fluid_force_;
  StepLimits limits_{};
  double step_ = 0;
  std::size_t steps_ = 0;
};

} // namespace pfv
