#include "studies/motion/terzaghi.hpp"

#include <cmath>
#include <numbers>

namespace studies {
namespace {

/// Sum over the modes M = pi (2 m + 1) / 2 until they no longer count.
template <class Term>
double sum_of_modes(double time_factor, const Term& term) {
  constexpr int most_modes = 100'000;
  double sum = 0;
  for (int m = 0; m < most_modes; ++m) {
    const double mode = std::numbers::pi * (2 * m + 1) / 2, left = std::exp(-mode * mode * time_factor);
    sum += term(mode) * left;
    if (left / mode < 1e-12)
      break;
  }
  return sum;
}

} // namespace

double terzaghi_pressure(double time_factor, double depth) {
  if (time_factor <= 0)
    return depth > 0 && depth < 2 ? 1 : 0;
  return sum_of_modes(time_factor, [&](double mode) { return 2 / mode * std::sin(mode * depth); });
}

double terzaghi_settlement(double time_factor) {
  return time_factor <= 0 ? 0 : 1 - sum_of_modes(time_factor, [](double mode) { return 2 / (mode * mode); });
}

} // namespace studies
