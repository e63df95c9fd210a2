#include "studies/runner/extrapolate.hpp"

#include "pfv/problem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace studies {

namespace {

double richardson(const Sample& coarse, const Sample& fine, double order) {
  const double ratio = std::pow(coarse.mesh_size / fine.mesh_size, order);
  return fine.value + (fine.value - coarse.value) / (ratio - 1);
}

double noise_of_richardson(const Sample& coarse, const Sample& fine, double order) {
  const double ratio = std::pow(coarse.mesh_size / fine.mesh_size, order);
  return (ratio * fine.noise + coarse.noise) / (ratio - 1);
}

// The p between 1 and `order` that comes nearest to putting the values on f0 + C h^p, by bisection: the quotient of
// their differences grows with p. Values that do not approach anything are of order 1.
double decay_order(const Sample& coarse, const Sample& middle, const Sample& fine, double order) {
  const double quotient = (coarse.value - middle.value) / (middle.value - fine.value);
  const auto expected = [&](double p) {
    const double h = std::pow(middle.mesh_size, p);
    return (std::pow(coarse.mesh_size, p) - h) / (h - std::pow(fine.mesh_size, p));
  };
  double low = 1, high = std::max(1.0, order);
  if (!(quotient > expected(low)))
    return low;
  for (int i = 0; i < 60; ++i) {
    const double between = (low + high) / 2;
    (expected(between) < quotient ? low : high) = between;
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
  const double value = richardson(coarse, fine, *order);
  const double noise = noise_of_richardson(coarse, fine, *order);
  if (samples.size() == 2) {
    const double distance = std::abs(fine.value - richardson(coarse, fine, std::min(*order, unseen_order)));
    return {value, extrapolation_safety * distance + noise, order};
  }
  const Sample coarsest = samples[samples.size() - 3];
  const double moved = std::abs(value - richardson(coarsest, coarse, *order));
  const double unexplained = std::max(0.0, moved - noise - noise_of_richardson(coarsest, coarse, *order));
  const double decay = std::pow(coarse.mesh_size / fine.mesh_size, decay_order(coarsest, coarse, fine, *order));
  return {value, std::max(unexplained / (decay - 1), least_share * std::abs(fine.value - value)) + noise, order};
}

BoundedField extrapolate_field(std::span<const double> mesh_sizes, std::span<const std::vector<double>> fields,
                               std::optional<double> order) {
  if (fields.empty() || fields.size() != mesh_sizes.size())
    throw pfv::InputError("fields and mesh sizes do not belong together");
  const std::size_t size = fields.front().size();
  for (const auto& field : fields)
    if (field.size() != size)
      throw pfv::InputError(fmt::format("{} and {} values cannot be of one case", size, field.size()));

  BoundedField result{std::vector<double>(size, std::numeric_limits<double>::quiet_NaN()), std::nullopt};
  double squares = 0;
  std::size_t known = 0;
  std::vector<Sample> samples(fields.size());
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t mesh = 0; mesh < fields.size(); ++mesh)
      samples[mesh] = {mesh_sizes[mesh], fields[mesh][i], 0};
    if (std::ranges::any_of(samples, [](const Sample& sample) { return std::isnan(sample.value); }))
      continue;
    const Bounded value = extrapolate(samples, order);
    result.values[i] = value.value;
    squares += value.error ? *value.error * *value.error : 0;
    ++known;
  }
  if (fields.size() > 1 && order && known > 0)
    result.error = std::sqrt(squares / static_cast<double>(known));
  return result;
}

} // namespace studies
