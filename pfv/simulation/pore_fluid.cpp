#include "pfv/simulation/pore_fluid.hpp"

#include "pfv/grains/grains.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "pfv/problem/validate.hpp"
#include "pfv/simulation/carry_over.hpp"
#include "pfv/solvers/multigrid_solver.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace pfv {
namespace {

/// m, the farthest that a grain has moved; along periodic axes against the mean of all, as moving together changes
/// nothing.
double moved(const std::vector<Vec3>& from, const Packing& packing, const PeriodicAxes& periodic) {
  Vec3 together = Vec3::Zero();
  if (periodic != PeriodicAxes{}) {
    for (std::size_t k = 0; k < from.size(); ++k)
      together += (packing.spheres[k].centre - from[k]) / static_cast<double>(from.size());
    for (int axis = 0; axis < 3; ++axis)
      together[axis] *= periodic[axis] ? 1 : 0;
  }
  double square = 0;
  for (std::size_t k = 0; k < from.size(); ++k)
    square = std::max(square, (packing.spheres[k].centre - from[k] - together).squaredNorm());
  return std::sqrt(square);
}

std::vector<Vec3> centres(const Packing& packing) {
  std::vector<Vec3> all;
  for (const Sphere& sphere : packing.spheres)
    all.push_back(sphere.centre);
  return all;
}

} // namespace

PoreFluid::PoreFluid(const FluidScene& scene, const Packing& packing, Clock& clock)
    : scene_(scene), preconditioner_(make_v_cycle()) {
  validate_level(scene.faces, scene.pressure_points);
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
  solution_.setZero(static_cast<Eigen::Index>(system_.unknowns()));
  solve(system_.right_side, {}, 0, scene_.tolerance, solution_);
  before_ = solution_;
  to_pores(solution_);
}

PoreFluid::~PoreFluid() = default;

void PoreFluid::build(const Packing& packing, Clock& clock) {
  const PeriodicAxes periodic = periodic_axes(scene_.faces);
  into_box_.clear();
  if (periodic != PeriodicAxes{})
    for (const Sphere& sphere : packing.spheres)
      into_box_.push_back(offset_into_box(packing.box, periodic, sphere.centre));
  network_ = build_pore_network(in_box(packing), periodic, clock);
  {
    const auto timing = clock.stage("conductances");
    throats_ = conductances(network_, scene_.options.conductance, scene_.options.walls, scene_.fluid.viscosity);
  }
  assemble_and_factor(clock);
  triangulated_at_ = refreshed_at_ = centres(packing);
  refreshed_box_ = packing.box;
}

Packing PoreFluid::in_box(const Packing& packing) const {
  Packing inside = packing;
  for (std::size_t k = 0; k < into_box_.size(); ++k)
    inside.spheres[k].centre += into_box_[k];
  return inside;
}

void PoreFluid::assemble_and_factor(Clock& clock) {
  const auto timing = clock.stage("assemble");
  system_ = assemble(network_, throats_, scene_.faces, scene_.pressure_points);
  flux_ = solid_flux(network_, scene_.options.walls);
  factor();
}

/// The fluid's storage waits for the length of a step.
void PoreFluid::factor() {
  stored_step_ = 0;
  preconditioner_->analyse(system_.matrix);
  preconditioner_->factor(system_.matrix);
}

void PoreFluid::set_storage(double step) {
  if (!scene_.compressible || stored_step_ == step)
    return;
  std::vector<double> storage(network_.pores.size());
  for (std::size_t i = 0; i < storage.size(); ++i)
    storage[i] = std::max(0.0, network_.pores.void_volume[i]) / scene_.compressible->bulk_modulus;
  stored_ = system_.matrix;
  stored_.diagonal() += to_unknowns(storage) / step;
  stored_step_ = step;
  preconditioner_->factor(stored_);
}

void PoreFluid::follow(const Packing& packing, Clock& clock) {
  const PeriodicAxes periodic = periodic_axes(scene_.faces);
  double drift = moved(refreshed_at_, packing, periodic);
  drift = std::max(drift, (packing.box.lower - refreshed_box_.lower).cwiseAbs().maxCoeff());
  drift = std::max(drift, (packing.box.upper - refreshed_box_.upper).cwiseAbs().maxCoeff());
  if (drift <= scene_.refresh_drift * mean_radius_)
    return;
  bool anew = moved(triangulated_at_, packing, periodic) > scene_.rebuild_drift * mean_radius_;
  if (!anew) {
    if (into_box_.empty())
      pfv::follow(network_, packing, clock);
    else
      pfv::follow(network_, in_box(packing), clock);
    anew = network_.inverted_throats > 0;
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
  const auto timing = clock.stage("assemble");
  const std::size_t unknowns = system_.unknowns();
  if (!refresh(system_, network_, throats_))
    system_ = assemble(network_, throats_, scene_.faces, scene_.pressure_points);
  flux_ = solid_flux(network_, scene_.options.walls);
  factor();
  if (system_.unknowns() != unknowns) {
    solution_.setZero(static_cast<Eigen::Index>(system_.unknowns()));
    before_ = solution_;
    mode_.resize(0);
  }
  refreshed_at_ = centres(packing);
  refreshed_box_ = packing.box;
  ++refreshed;
}

void PoreFluid::renew(const Packing& packing, Clock& clock) {
  const auto bodies = flux_.body;
  build(packing, clock);
  const auto carried = carried_over(bodies, pressure_, flux_.body, flux_.bodies);
  solution_.setZero(static_cast<Eigen::Index>(system_.unknowns()));
  for (std::size_t i = 0; i < carried.size(); ++i)
    if (system_.unknown_of_pore[i] >= 0)
      solution_[system_.unknown_of_pore[i]] = carried[i] - system_.level;
  start_from_solution();
}

/// Forgets all but the pressures.
void PoreFluid::start_from_solution() {
  to_pores(solution_);
  before_ = solution_;
  mode_.resize(0);
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

void PoreFluid::impose(Face face, double pressure) {
  auto* open = std::get_if<Pressure>(&scene_.faces[index(face)]);
  if (!open)
    throw InputError(fmt::format("{} has no pressure that could be another one", face_names[index(face)]));
  open->value = pressure;
  pfv::impose(system_, face, pressure);
  renew_right_side(system_, network_);
}

Eigen::VectorXd PoreFluid::to_unknowns(const std::vector<double>& of_pores) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(system_.unknowns()));
  for (std::size_t i = 0; i < of_pores.size(); ++i)
    if (const int unknown = system_.unknown_of_pore[i]; unknown >= 0)
      sum[unknown] += of_pores[i];
  return sum;
}

/// Pressures of all pores: known ones, and those of the unknowns above the level.
void PoreFluid::to_pores(const Eigen::VectorXd& x) {
  set_pore_pressures(system_, x, pressure_);
}

Eigen::VectorXd PoreFluid::product(const Eigen::VectorXd& x, std::span<const double> per_mass, double step) {
  const FlowMatrix& matrix = stored_step_ > 0 ? stored_ : system_.matrix;
  if (per_mass.empty())
    return matrix * x;
  of_pores_.resize(flux_.pores());
  for (std::size_t i = 0; i < of_pores_.size(); ++i) {
    const int unknown = system_.unknown_of_pore[i];
    of_pores_[i] = unknown >= 0 ? x[unknown] : 0;
  }
  pressure_forces(flux_, of_pores_, scratch_force_);
  for (std::size_t k = 0; k < scratch_force_.size(); ++k)
    scratch_force_[k] *= step * per_mass[k];
  volume_rates(flux_, scratch_force_, rate_);
  return matrix * x + to_unknowns(rate_);
}

void PoreFluid::solve(const Eigen::VectorXd& right_side, std::span<const double> per_mass, double step,
                      double tolerance, Eigen::VectorXd& x) {
  constexpr int most_steps = 2000;
  ++solves;
  if (right_side.size() == 0)
    return;
  if (right_side.isZero(0)) {
    x.setZero();
    return;
  }
  Eigen::VectorXd residual = right_side - product(x, per_mass, step);
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(x.size()), correction(x.size());
  double before = 1;
  for (int n = 0; n < most_steps; ++n) {
    const double power = preconditioner_->apply(residual, correction);
    if (!std::isfinite(power))
      throw SolveError("the pressure of the pores is not finite");
    if (power <= tolerance * tolerance * std::abs(x.dot(right_side)))
      return;
    direction = correction + power / before * direction;
    before = power;
    const Eigen::VectorXd image = product(direction, per_mass, step);
    const double length = power / direction.dot(image);
    x += length * direction;
    residual -= length * image;
    ++iterations;
  }
  throw SolveError(
      fmt::format("the pressures of the pores did not settle to {:.0e} in {} steps", tolerance, most_steps));
}

const std::vector<Vec3>& PoreFluid::forces(std::span<const Vec3> velocity, std::span<const double> per_mass,
                                           double step, Clock& clock) {
  set_storage(step);
  Eigen::VectorXd right_side;
  {
    const auto timing = clock.stage("volume rates");
    // What is known pushes already: imposed pressures, and the level that unknown ones count from.
    std::vector<double> known(network_.pores.size(), system_.level);
    for (std::size_t i = 0; i < known.size(); ++i)
      if (const auto* pore = system_.known(i))
        known[i] = pore->pressure;
    pressure_forces(flux_, known, force_);
    std::vector<Vec3> moving(velocity.begin(), velocity.end());
    if (!per_mass.empty())
      for (std::size_t k = 0; k < moving.size(); ++k)
        moving[k] += step * per_mass[k] * force_[k];
    volume_rates(flux_, moving, rate_);
    right_side = system_.right_side - to_unknowns(rate_);
    if (scene_.compressible) {
      std::vector<double> kept(network_.pores.size());
      for (std::size_t i = 0; i < kept.size(); ++i)
        kept[i] = std::max(0.0, network_.pores.void_volume[i]) / scene_.compressible->bulk_modulus / step *
                  (pressure_[i] - system_.level);
      right_side += to_unknowns(kept);
    }
  }
  {
    const auto timing = clock.stage("solve");
    Eigen::VectorXd guess = 2 * solution_ - before_;
    before_ = solution_;
    solve(right_side, per_mass, step, scene_.tolerance, guess);
    solution_ = std::move(guess);
  }
  const auto timing = clock.stage("forces");
  to_pores(solution_);
  pressure_forces(flux_, pressure_, force_);
  return force_;
}

double PoreFluid::largest_rate(std::span<const double> per_mass, Clock& clock) {
  const auto timing = clock.stage("stable step");
  constexpr int most_steps = 100;
  constexpr double settled = 1e-3, tolerance = 1e-4;
  const auto size = static_cast<Eigen::Index>(system_.unknowns());
  stored_step_ = 0;
  preconditioner_->factor(system_.matrix);
  if (mode_.size() != size) {
    mode_.resize(size);
    for (Eigen::Index i = 0; i < size; ++i)
      mode_[i] = std::sin(1.0 + 2.0 * static_cast<double>(i));
  }
  double rate = 0;
  for (int n = 0; n < most_steps && size > 0; ++n) {
    // x -> A^-1 B M^-1 B^T x, whose Rayleigh quotient in the norm of A is x.B M^-1 B^T x / x.A x.
    const Eigen::VectorXd resisted = system_.matrix * mode_;
    const Eigen::VectorXd pushed = product(mode_, per_mass, 1) - resisted;
    const double next = mode_.dot(pushed) / mode_.dot(resisted);
    Eigen::VectorXd answer = next * mode_;
    solve(pushed, {}, 0, tolerance, answer);
    mode_ = answer / answer.norm();
    const bool done = std::abs(next - rate) < settled * next && n > 10;
    rate = next;
    if (done)
      break;
  }
  return rate;
}

double PoreFluid::dissipation() const {
  double power = 0;
  for (std::size_t t = 0; t < network_.throats.size(); ++t) {
    const auto [i, j] = network_.throats.pores[t];
    const double drop = pressure_[i] - pressure_[j];
    power += system_.conductance[t] * drop * drop;
  }
  return power;
}

} // namespace pfv
