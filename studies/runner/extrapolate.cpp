#include "studies/runner/extrapolate.hpp"

#include "pfv/problem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace studies {

namespace {

double richardson(const Sample& coarse, const Sample& fine, double order) {
  const double ratio = std::pow(coarse.mesh_size / fine.mesh_size, order);
  return fine.value + (fine.value - coarse.value) / (ratio - 1);
}

// The p that makes three values lie on f0 + C h^p, by bisection: the quotient grows with p. Nothing outside [low,
// high].
std::optional<double> observed_order(const Sample& coarse, const Sample& middle, const Sample& fine, double low,
                                     double high) {
  const double quotient = (coarse.value - middle.value) / (middle.value - fine.value);
  if (!std::isfinite(quotient) || quotient <= 0)
    return std::nullopt;
  const auto expected = [&](double p) {
    const double h = std::pow(middle.mesh_size, p);
    return (std::pow(coarse.mesh_size, p) - h) / (h - std::pow(fine.mesh_size, p));
  };
  if (quotient < expected(low) || quotient > expected(high))
    return std::nullopt;
  for (int i = 0; i < 60; ++i) {
    const double middle_order = (low + high) / 2;
    (expected(middle_order) < quotient ? low : high) = middle_order;
  }
  return (low + high) / 2;
}

} // namespace

Bounded extrapolate(std::vector<Sample> samples, std::optional<double> order) {
  if (samples.empty())
    throw pfv::InputError("nothing to extrapolate");
  std::ranges::sort(samples, std::ranges::greater{}, &Sample::mesh_size);
  if (const auto same = std::ranges::adjacent_find(samples, {}, &Sample::mesh_size); same != samples.end())
    throw pfv::InputError(
        fmt::format("two values at mesh size {}: extrapolation needs different ones", same->mesh_size));
  const Sample fine = samples.back();
  if (samples.size() == 1 || !order)
    return {fine.value, std::nullopt, std::nullopt};

  const Sample coarse = samples[samples.size() - 2];
  if (samples.size() == 2) {
    const double value = richardson(coarse, fine, *order);
    return {value, extrapolation_safety * std::abs(fine.value - value), order};
  }
  const Sample coarsest = samples[samples.size() - 3];
  const auto observed = observed_order(coarsest, coarse, fine, 0.5, *order + 1);
  const double value = richardson(coarse, fine, observed.value_or(*order));
  const auto [least, most] = std::minmax({coarsest.value, coarse.value, fine.value});
  const double spread = observed ? 0 : most - least;
  return {value, extrapolation_safety * std::max(std::abs(fine.value - value), spread), observed.value_or(*order)};
}

BoundedForces extrapolate_forces(std::span<const double> mesh_sizes, std::span<const std::vector<pfv::Vec3>> forces,
                                 std::optional<double> order) {
  if (forces.empty() || forces.size() != mesh_sizes.size())
    throw pfv::InputError("forces and mesh sizes do not belong together");
  const std::size_t spheres = forces.front().size();
  for (const auto& list : forces)
    if (list.size() != spheres)
      throw pfv::InputError(fmt::format("forces on {} and on {} spheres cannot be of one case", spheres, list.size()));

  BoundedForces result{std::vector<pfv::Vec3>(spheres), std::nullopt};
  double errors = 0;
  double squares = 0;
  const bool bounded = forces.size() > 1 && order.has_value();
  std::vector<Sample> samples(forces.size());
  for (std::size_t sphere = 0; sphere < spheres; ++sphere) {
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t mesh = 0; mesh < forces.size(); ++mesh)
        samples[mesh] = {mesh_sizes[mesh], forces[mesh][sphere][axis]};
      const Bounded component = extrapolate(samples, order);
      result.values[sphere][axis] = component.value;
      squares += component.value * component.value;
      errors += component.error ? *component.error * *component.error : 0;
    }
  }
  if (bounded && squares > 0)
    result.relative_error = std::sqrt(errors / squares);
  return result;
}

} // namespace studies
