// The pressures of a PoreFluid: where they start, what is imposed, kept and handed on of them.
#include "pfv/simulation/pore_fluid.hpp"

#include "pfv/problem/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace pfv {

void PoreFluid::start_in_steady_flow() {
  const auto solve = [&](const FlowSystem& system) {
    const GramTerm none;
    PressureSolver steady;
    steady.set(system.matrix, none);
    steady.solve(system.right_side, scene_.tolerance, solution_.setZero(static_cast<Eigen::Index>(system.unknowns())));
    set_pore_pressures(system, solution_, pressure_);
  };
  if (!scene_.compressible)
    return solve(system_);
  solve(pfv::assemble(network_, throats_, scene_.faces, scene_.pressure_points));
  start_from(std::vector(pressure_));
}

/// Forgets all but the pressures (Pa, by pore).
void PoreFluid::start_from(const std::vector<double>& pressure) {
  solution_.setZero(static_cast<Eigen::Index>(system_.unknowns()));
  for (std::size_t i = 0; i < pressure.size(); ++i)
    if (system_.unknown_of_pore[i] >= 0)
      solution_[system_.unknown_of_pore[i]] = pressure[i] - system_.level;
  start_from_solution();
}

void PoreFluid::start_from_solution() {
  set_pore_pressures(system_, solution_, pressure_);
  increments_.clear();
  mode_.resize(0);
}

/// No fluid is lost between other pores: moves all unknown pressures alike until the mean is this (Pa).
void PoreFluid::keep_mean(double pressure) {
  const double moved = scene_.compressible->bulk_modulus * storage_.sum();
  if (!(moved > 0))
    return;
  solution_.array() += (pressure - mean_pressure()) * network_.porosity() * network_.box.volume() / moved;
  start_from_solution();
}

/// Moves all unknown pressures alike until what enters, is stored and is displaced balances over all pores together.
/// The error that is allowed of pressures would else be fluid that a sealed box loses, step after step.
void PoreFluid::balance_all_together() {
  const double of_all = of_uniform_.sum();
  if (of_all > 0)
    solution_.array() += (right_side_.sum() - of_uniform_.dot(solution_)) / of_all;
}

FluidState PoreFluid::state() const {
  return {{solution_.begin(), solution_.end()}, system_.level, {refreshed, rebuilt, iterations, solves}};
}

void PoreFluid::restore(const FluidState& state) {
  if (state.above_level.size() != system_.unknowns())
    throw InputError(fmt::format("the checkpoint has \"{}\" unknown pressures, the scene {}: other faces have theirs "
                                 "imposed",
                                 state.above_level.size(), system_.unknowns()));
  std::ranges::copy(state.above_level, solution_.begin());
  if (state.level != system_.level) // other pressures are imposed now
    solution_.array() += state.level - system_.level;
  start_from_solution();
  refreshed = state.counts.refreshed;
  rebuilt = state.counts.rebuilt;
  iterations = state.counts.iterations;
  solves = state.counts.solves;
}

void PoreFluid::impose_at(double time) {
  bool others = false;
  for (const Face face : all_faces) {
    const auto& changing = scene_.in_time[index(face)];
    if (!changing)
      continue;
    const Pressure now{changing->at(time)};
    if (scene_.faces[index(face)] == FaceCondition(now))
      continue;
    scene_.faces[index(face)] = now;
    impose(system_, face, now.value);
    others = true;
  }
  if (!others)
    return;
  renew_right_side(system_, network_);
  set_known_force();
}

void PoreFluid::set_known_force() {
  std::vector<double> known(network_.pores.size(), system_.level);
  drives_ = false;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (const auto* pore = system_.known(i)) {
      known[i] = pore->pressure;
      drives_ = drives_ || (pore->source >= 0 && pore->pressure != 0);
    }
  pressure_forces(flux_, known, known_force_);
}

void PoreFluid::add_to_unknowns(const std::vector<double>& of_pores, Eigen::VectorXd& sum) const {
  for (std::size_t i = 0; i < of_pores.size(); ++i)
    if (const int unknown = system_.unknown_of_pore[i]; unknown >= 0)
      sum[unknown] += of_pores[i];
}

} // namespace pfv
