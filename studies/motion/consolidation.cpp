#include "studies/motion/consolidation.hpp"

#include "studies/motion/terzaghi.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace studies {

double expected_settlement(const Layer& layer, double time_factor) {
  return layer.share_of_ends + (1 - layer.share_of_ends) * terzaghi_settlement(time_factor);
}

double expected_pressure(const Layer& layer, double time_factor, double share) {
  const double depth = 2 * (share - layer.lower) / (layer.upper - layer.lower);
  return depth > 0 && depth < 2 ? terzaghi_pressure(time_factor, depth) : 0;
}

ConsolidationError error_of(const Consolidation& test) {
  constexpr double first = 0.05, last = 1, round_off = 1e-6;
  ConsolidationError error;
  double count = 0;
  for (const Moment& moment : test.moments) {
    const double t = moment.time_factor;
    if (t < first - round_off || t > last * 1.01)
      continue;
    const double of_settlement = std::abs(moment.settlement - expected_settlement(test.layer, t));
    const double of_pressure = std::abs(moment.middle_pressure - expected_pressure(test.layer, t, 0.5));
    error.largest_settlement = std::max(error.largest_settlement, of_settlement);
    error.largest_pressure = std::max(error.largest_pressure, of_pressure);
    error.rms_settlement += of_settlement * of_settlement;
    error.rms_pressure += of_pressure * of_pressure;
    ++count;
  }
  if (count > 0) {
    error.rms_settlement = std::sqrt(error.rms_settlement / count);
    error.rms_pressure = std::sqrt(error.rms_pressure / count);
  }
  return error;
}

ExperimentReport run_consolidation(bool quick, const Say& say) {
  Oedometer test;
  test.grains = quick ? 1000 : 5000;
  std::vector<double> time_factors{0.01, 0.02, 0.03, 0.04};
  for (int k = 1; k <= 20; ++k)
    time_factors.push_back(0.05 * k);
  const Consolidation first = consolidate(test, time_factors, say);
  std::vector<OtherLayer> others;
  for (unsigned seed = test.seed + 1; !quick && seed <= test.seed + 2; ++seed) {
    Oedometer other = test;
    other.seed = seed;
    say(fmt::format("the layer of seed {}", seed), 0);
    others.push_back({seed, error_of(consolidate(other, time_factors, say))});
  }
  return consolidation_report(first, test, others);
}

} // namespace studies
