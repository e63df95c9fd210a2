#include "pfv/simulation/simulation.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace pfv {
namespace {

constexpr std::size_t steps_between_limits = 1000, steps_between_checks = 20;

std::vector<double> per_mass(const GrainCycle& cycle) {
  std::vector<double> inverse;
  for (const double mass : cycle.grains.mass)
    inverse.push_back(1 / mass);
  for (const Face face : all_faces) {
    const auto* loaded = std::get_if<LoadedWall>(&cycle.scene.walls.motion[index(face)]);
    inverse.push_back(loaded ? 1 / loaded->mass : 0);
  }
  return inverse;
}

/// N, of the stress on a loaded wall, or of who moves one against the fluid.
Vec3 load_on_wall(const GrainCycle& cycle, std::size_t face, const Vec3& of_fluid) {
  const WallMotion& motion = cycle.scene.walls.motion[face];
  const auto wall = static_cast<Face>(face);
  if (const auto* loaded = std::get_if<LoadedWall>(&motion))
    return -loaded->stress * area_of(cycle.grains.packing.box, wall) * outward_normal(wall);
  return std::holds_alternative<MovingWall>(motion) ? Vec3(-of_fluid) : Vec3::Zero();
}

void require_fluid_to_repeat_with_grains(const Scene& scene) {
  if (scene.fluid && periodic_axes(scene.fluid->faces) != scene.grains.walls.periodic)
    throw InputError("grains and fluid must be periodic along the same axes");
}

GrainCycle cycle_from(const Checkpoint& checkpoint, const Scene& scene) {
  require_same_grains(checkpoint, scene);
  GrainCycle cycle(checkpoint.grains, scene.grains);
  cycle.contacts.restore(checkpoint.contacts);
  cycle.contacts.renew(cycle.grains);
  cycle.loads = checkpoint.loads;
  cycle.on_wall = checkpoint.on_wall;
  cycle.energy = checkpoint.energy;
  cycle.broken_bonds = checkpoint.broken_bonds;
  cycle.time = checkpoint.time;
  return cycle;
}

} // namespace

void require_growth_alone(const Scene& scene) {
  if (!scene.grains.growth)
    return;
  if (scene.fluid || scene.grains.lubrication)
    throw InputError("growth of radii is for dry grains: neither a flow nor lubrication may be beside it");
  for (const Face face : all_faces)
    if (const auto* loaded = std::get_if<LoadedWall>(&scene.grains.walls.motion[index(face)]))
      throw InputError(
          fmt::format("{} at a stress of \"{}\" (Pa) cannot be beside growth of radii, which has a stress of "
                      "its own: walls must be fixed or move at a velocity",
                      face_names[index(face)], shortest(loaded->stress)));
}

double StepLimits::joint() const {
  const auto rate_of = [](const std::optional<double>& limit) { return limit ? 2 / *limit : 0; };
  const double frequency = 2 / contact, rate = rate_of(viscous) + rate_of(lubrication);
  return 4 / (rate + std::hypot(rate, 2 * frequency));
}

double StepLimits::chosen() const {
  const auto safe = [](const std::optional<double>& limit) {
    return limit ? std::optional(0.8 * *limit) : std::nullopt;
  };
  return StepLimits{0.3 * contact, safe(viscous), safe(lubrication)}.joint();
}

StepLimits limits_of(const GrainCycle& cycle) {
  return {cycle.contact_limit(), std::nullopt, cycle.lubrication_limit()};
}

Simulation::Simulation(const Scene& scene) : Simulation(scene, GrainCycle(scene.packing, scene.grains)) {}

Simulation::Simulation(const Scene& scene, GrainCycle start) : scene_(scene), cycle_(std::move(start)) {
  cycle_.set_scene(scene.grains);
  scene_.packing.spheres.clear();
  require_fluid_to_repeat_with_grains(scene);
  require_growth_alone(scene);
  if (scene.fluid) {
    fluid_.emplace(at_time(*scene.fluid, cycle_.time), cycle_.grains.packing, clock_);
    per_mass_ = per_mass(cycle_);
  }
  choose_step();
}

Simulation::Simulation(const Scene& scene, const Checkpoint& from) : Simulation(scene, cycle_from(from, scene)) {
  steps_ = from.steps;
  if (!fluid_ || !from.fluid)
    return;
  fluid_->restore(*from.fluid);
  choose_step();
}

Checkpoint Simulation::checkpoint() {
  check_stability();
  cycle_.contacts.renew(cycle_.grains);
  if (fluid_) {
    fluid_->impose_at(cycle_.time);
    fluid_->renew(cycle_.grains.packing, clock_);
  }
  Checkpoint saved{cycle_.grains,
                   cycle_.scene.cohesion,
                   cycle_.contacts.memory(),
                   cycle_.loads,
                   cycle_.on_wall,
                   cycle_.energy,
                   cycle_.broken_bonds,
                   steps_,
                   cycle_.time,
                   fluid_ ? std::optional(fluid_->state()) : std::nullopt};
  choose_step();
  return saved;
}

void Simulation::choose_step() {
  limits_ = limits_of(cycle_);
  if (fluid_ && std::holds_alternative<Explicit>(scene_.scheme))
    limits_.viscous = 2 / fluid_->largest_rate(per_mass_, scene_.step.value_or(limits_.chosen()), clock_);
  step_ = scene_.step.value_or(limits_.chosen());
}

std::vector<Vec3> Simulation::body_velocities() const {
  std::vector<Vec3> velocity;
  velocity.reserve(cycle_.grains.size() + 6);
  for (const Velocity& of : cycle_.grains.velocity)
    velocity.push_back(of.translation);
  for (const Face face : all_faces)
    velocity.push_back(cycle_.grains.wall_velocity[index(face)] * Vec3::Unit(index(axis_of(face))));
  return velocity;
}

void Simulation::advance() {
  if (steps_ > 0 && steps_ % steps_between_limits == 0 && !scene_.step)
    choose_step();
  cycle_.load(step_, clock_);
  if (fluid_)
    advance_with_fluid();
  else
    cycle_.kick(step_, clock_);
  cycle_.drift(step_, clock_);
  ++steps_;
  if (steps_ % steps_between_checks == 0)
    check_stability();
}

void Simulation::advance_with_fluid() {
  fluid_->impose_at(cycle_.time);
  fluid_->follow(cycle_.grains.packing, clock_);
  const auto start = cycle_.grains.velocity;
  const auto before = body_velocities();
  cycle_.kick_undamped(step_, clock_);
  fluid_force_ = std::holds_alternative<SemiImplicit>(scene_.scheme)
                     ? fluid_->forces(body_velocities(), per_mass_, step_, clock_)
                     : fluid_->forces(before, {}, step_, clock_);
  const auto timing = clock_.stage("motion");
  Grains& grains = cycle_.grains;
  for (std::size_t i = 0; i < grains.size(); ++i)
    grains.velocity[i].translation += step_ * per_mass_[i] * fluid_force_[i];
  for (std::size_t face = 0; face < 6; ++face) {
    const std::size_t k = grains.size() + face;
    grains.wall_velocity[face] += step_ * per_mass_[k] * fluid_force_[k][face / 2];
  }
  cycle_.damp(before, start);
  auto mean = body_velocities();
  double given = 0; // J/s, to the bodies
  for (std::size_t k = 0; k < mean.size(); ++k) {
    mean[k] = 0.5 * (before[k] + mean[k]);
    given += fluid_force_[k].dot(mean[k]);
  }
  const double imposed = fluid_->inflow_power(mean);
  cycle_.energy.fluid += step_ * (imposed - given);
  cycle_.energy.loads += step_ * imposed;
  for (std::size_t face = 0; face < 6; ++face) {
    const std::size_t k = grains.size() + face;
    cycle_.energy.loads += step_ * load_on_wall(cycle_, face, fluid_force_[k]).dot(mean[k]);
  }
}

void Simulation::check_stability() {
  double fastest = 0;
  for (const Velocity& velocity : cycle_.grains.velocity) {
    const double square = velocity.translation.squaredNorm();
    if (!std::isfinite(square)) {
      fastest = std::numeric_limits<double>::infinity();
      break;
    }
    fastest = std::max(fastest, square);
  }
  fastest = std::sqrt(fastest);
  const double smallest = std::ranges::min(cycle_.grains.packing.spheres, {}, &Sphere::radius).radius;
  if (fastest * step_ < 0.5 * smallest)
    return;
  std::string limits = fmt::format("{:.3g} s of the contacts", limits_.contact);
  if (limits_.viscous)
    limits += fmt::format(", {:.3g} s of the fluid", *limits_.viscous);
  if (limits_.lubrication)
    limits += fmt::format(", {:.3g} s of the lubrication", *limits_.lubrication);
  if (limits_.viscous || limits_.lubrication)
    limits += fmt::format(", {:.3g} s of all together", limits_.joint());
  throw SolveError(fmt::format("left stability at {:.6g} s: a grain moves by {:.2g} of the smallest radius in a step "
                               "of {:.3g} s; the limits are {}",
                               cycle_.time, fastest * step_ / smallest, step_, limits));
}

} // namespace pfv
