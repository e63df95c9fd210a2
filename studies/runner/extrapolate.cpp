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
      samples[mesh] = {mesh_sizes[mesh], fields[mesh][i]};
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
