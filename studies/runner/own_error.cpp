#include "studies/runner/own_error.hpp"

#include <algorithm>
#include <cmath>

namespace studies {

namespace {

double count_or_zero(const reference::Answer& answer, const char* name) {
  const auto found = answer.counts.find(name);
  return found == answer.counts.end() || std::isnan(found->second) ? 0 : found->second;
}

} // namespace

double noise(const reference::Answer& answer) {
  return noise_share * std::abs(count_or_zero(answer, "flux_imbalance"));
}

double bridge_error(const reference::Answer& answer) {
  if (count_or_zero(answer, "bridges") == 0)
    return 0;
  return bridge_share * std::max(0.0, -count_or_zero(answer, "volume_error"));
}

} // namespace studies
