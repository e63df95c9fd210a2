#include "pfv/flow/median.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace pfv {
namespace {

/// Positive numbers are ordered as their bits are. The first ones, exponent and a sixteenth of its octave, sort them
/// into bins.
constexpr int lower_bits = 48;
constexpr std::size_t bins = std::size_t(1) << (63 - lower_bits);

std::size_t bin_of(double value) {
  return std::bit_cast<std::uint64_t>(value) >> lower_bits;
}

} // namespace

double positive_median(const std::vector<double>& values) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::array<std::uint32_t, bins> in_bin{};
  std::size_t count = 0;
  for (const double value : values)
    if (value > 0 && value < infinite) {
      ++in_bin[bin_of(value)];
      ++count;
    }
  if (count == 0)
    return 0;
  std::size_t bin = 0, before = count / 2; // in order, within the bin
  for (; before >= in_bin[bin]; ++bin)
    before -= in_bin[bin];
  std::vector<double> within;
  within.reserve(in_bin[bin]);
  for (const double value : values)
    if (value > 0 && bin_of(value) == bin)
      within.push_back(value);
  const auto middle = within.begin() + static_cast<std::ptrdiff_t>(before);
  std::ranges::nth_element(within, middle);
  return *middle;
}

} // namespace pfv
