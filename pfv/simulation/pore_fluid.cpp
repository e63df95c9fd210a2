#include "pfv/simulation/pore_fluid.hpp"

#include "pfv/grains/grains.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "pfv/problem/validate.hpp"
#include "pfv/simulation/carry_over.hpp"
#include "pfv/simulation/solid_term.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace pfv {
namespace {

/// A facet may turn around as far as grains may part unnoticed: the two pores it divides then have nearly one centre
/// and one pressure, whichever way the space around them is divided.
bool turned_around(const PoreNetwork& network, double allowed) {
  return network.inverted_throats > 0 && *std::ranges::min_element(network.throats.length) < -allowed;
}

} // namespace

FluidScene at_time(FluidScene scene, double time) {
  for (const Face face : all_faces)
    if (const auto& changing = scene.in_time[index(face)])
      scene.faces[index(face)] = Pressure{changing->at(time)};
  return scene;
}

PoreFluid::PoreFluid(const FluidScene& scene, const Packing& packing, Clock& clock) : scene_(scene) {
  if (!scene.compressible)
    validate_level(scene.faces, scene.pressure_points, "or the fluid be compressible");
  for (const auto& condition : scene.faces) {
    if (std::holds_alternative<Flux>(condition))
      throw InputError("a face of a box whose grains move must be slip, periodic or at a pressure, not at a flux");
    if (const auto* repeats = std::get_if<Periodic>(&condition); repeats && repeats->gradient != 0)
      throw InputError(fmt::format("the gradient \"{}\" along a periodic axis of a box whose grains move must be 0",
                                   shortest(repeats->gradient)));
  }
  for (const Sphere& sphere : packing.spheres)
    mean_radius_ += sphere.radius / static_cast<double>(packing.spheres.size());
  build(packing, clock);
  start_in_steady_flow();
}

void PoreFluid::build(const Packing& packing, Clock& clock) {
  const PeriodicAxes periodic = periodic_axes(scene_.faces);
  into_box_.clear();
  if (periodic != PeriodicAxes{})
    for (const Sphere& sphere : packing.spheres)
      into_box_.push_back(offset_into_box(packing.box, periodic, sphere.centre));
  network_ = build_pore_network(in_box(packing), periodic, clock, reads_openings(scene_.options.conductance));
  {
    const auto timing = clock.stage("conductances");
    throats_ = conductances(network_, scene_.options.conductance, scene_.options.walls, scene_.fluid.viscosity);
  }
  assemble_anew(clock);
  since_built_.start(packing);
  since_refreshed_.start(packing);
}

Packing PoreFluid::in_box(const Packing& packing) const {
  Packing inside = packing;
  for (std::size_t k = 0; k < into_box_.size(); ++k)
    inside.spheres[k].centre += into_box_[k];
  return inside;
}

void PoreFluid::assemble_anew(Clock& clock) {
  const auto timing = clock.stage("assemble");
  system_ = assemble(network_, throats_, scene_.faces, scene_.pressure_points,
                     scene_.compressible ? Isolated::unknown : Isolated::at_mean);
  set_flux();
  increments_.clear();
  mode_.resize(0);
}

void PoreFluid::set_flux() {
  flux_ = solid_flux(network_, scene_.options.walls);
  set_known_force();
  if (scene_.compressible) {
    std::vector<double> storage(network_.pores.size());
    for (std::size_t i = 0; i < storage.size(); ++i)
      storage[i] = std::max(0.0, network_.pores.void_volume[i]) / scene_.compressible->bulk_modulus;
    add_to_unknowns(storage, storage_.setZero(static_cast<Eigen::Index>(system_.unknowns())));
  }
  matrix_is_set_ = false;
}

/// The matrix of the flow, and on its diagonal what a compressible fluid stores in a step (s); `room` is for the two.
const FlowMatrix& PoreFluid::with_storage(double step, FlowMatrix& room) const {
  if (!scene_.compressible)
    return system_.matrix;
  room = system_.matrix;
  room.diagonal() += storage_ / step;
  return room;
}

/// What a step adds to the matrix of the flow: the storage of the fluid, and the motion of the solid within it.
void PoreFluid::set_matrix(std::span<const double> per_mass, double step) {
  const bool implicit = !per_mass.empty();
  if (matrix_is_set_ && step == of_step_ && implicit == !solid_.empty())
    return;
  solid_ = implicit ? solid_term(flux_, system_, per_mass, step) : GramTerm{};
  const FlowMatrix& matrix = with_storage(step, stored_);
  solver_.set(matrix, solid_);
  if (scene_.compressible)
    multiply(matrix, solid_, Eigen::VectorXd::Ones(matrix.rows()), of_block_, of_uniform_);
  solver_.renew(increments_);
  of_step_ = step;
  matrix_is_set_ = true;
}

void PoreFluid::follow(const Packing& packing, Clock& clock) {
  if (!since_refreshed_.exceeds(scene_.refresh_drift * mean_radius_, packing, flux_.body))
    return;
  bool anew = since_built_.exceeds(scene_.rebuild_drift * mean_radius_, packing, flux_.body);
  if (!anew) {
    if (into_box_.empty())
      pfv::follow(network_, packing, clock);
    else
      pfv::follow(network_, in_box(packing), clock);
    anew = turned_around(network_, scene_.refresh_drift * mean_radius_);
  }
  if (anew) {
    renew(packing, clock);
    ++rebuilt;
    return;
  }
  {
    const auto timing = clock.stage("conductances");
    update(throats_, network_, scene_.options.conductance, scene_.options.walls, scene_.fluid.viscosity);
  }
  if (refresh_system(clock))
    start_from(std::vector(pressure_));
  since_refreshed_.start(packing);
  ++refreshed;
}

void PoreFluid::renew(const Packing& packing, Clock& clock) {
  const auto bodies = flux_.body;
  const double mean = mean_pressure();
  build(packing, clock);
  start_from(carried_over(bodies, pressure_, flux_.body, flux_.bodies));
  if (scene_.compressible)
    keep_mean(mean);
}

/// Whether the unknowns are others now.
bool PoreFluid::refresh_system(Clock& clock) {
  {
    const auto timing = clock.stage("assemble");
    if (refresh(system_, network_, throats_)) {
      set_flux();
      return false;
    }
  }
  assemble_anew(clock);
  return true;
}

const std::vector<Vec3>& PoreFluid::forces(std::span<const Vec3> velocity, std::span<const double> per_mass,
                                           double step, Clock& clock) {
  {
    const auto timing = clock.stage("volume rates");
    // What is known pushes already: imposed pressures, and the level that unknown ones count from.
    moving_.assign(velocity.begin(), velocity.end());
    for (std::size_t k = 0; k < per_mass.size(); ++k)
      moving_[k] += step * per_mass[k] * known_force_[k];
    volume_rates(flux_, moving_, rate_);
    right_side_.setZero(solution_.size());
    add_to_unknowns(rate_, right_side_);
    right_side_ = system_.right_side - right_side_;
    if (scene_.compressible)
      right_side_ += storage_.cwiseProduct(solution_) / step;
  }
  {
    const auto timing = clock.stage("solve");
    set_matrix(per_mass, step);
    iterations += static_cast<std::size_t>(solver_.solve(right_side_, scene_.tolerance, solution_, &increments_));
    ++solves;
    if (scene_.compressible)
      balance_all_together();
  }
  const auto timing = clock.stage("forces");
  set_pore_pressures(system_, solution_, pressure_);
  pressure_forces(flux_, pressure_, force_);
  return force_;
}

} // namespace pfv
