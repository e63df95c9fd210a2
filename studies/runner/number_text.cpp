#include "studies/runner/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace studies {

namespace {

// "1.2e-04" reads "1.2e-4".
std::string without_padding(std::string text) {
  const auto e = text.find('e');
  if (e != std::string::npos && e + 3 < text.size() && text[e + 2] == '0')
    text.erase(e + 2, 1);
  return text;
}

std::string significant(double value, int digits) {
  return without_padding(fmt::format("{:.{}g}", value, digits));
}

int decade(double value) {
  return value == 0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value))));
}

} // namespace

std::string percent(double fraction) {
  if (!std::isfinite(fraction))
    return "n.a.";
  const double value = 100 * fraction;
  return std::abs(value) >= 99.5 ? fmt::format("{:.0f} %", value) : significant(value, 2) + " %";
}

std::string with_error(double value, std::optional<double> error) {
  if (!std::isfinite(value))
    return "n.a.";
  const int exponent = decade(value);
  // Between 0.01 and 9999 a number is easier to read as it is.
  const int shown_exponent = exponent < -2 || exponent > 3 ? exponent : 0;
  const double scale = std::pow(10.0, shown_exponent);
  const std::string power = shown_exponent == 0 ? "" : fmt::format("e{}", shown_exponent);
  if (!error || !std::isfinite(*error) || *error <= 0)
    return fmt::format("{:.{}f}{}", value / scale, std::max(0, 3 - (exponent - shown_exponent)), power);
  const int places = std::clamp(1 - (decade(*error) - shown_exponent), 0, 6);
  if (power.empty())
    return fmt::format("{:.{}f} ± {:.{}f}", value, places, *error, places);
  return fmt::format("({:.{}f} ± {:.{}f}){}", value / scale, places, *error / scale, places, power);
}

std::string count(double value) {
  if (value < 1e6)
    return fmt::format("{:.0f}", value);
  const int exponent = decade(value);
  return fmt::format("{:.1f}e{}", value / std::pow(10.0, exponent), exponent);
}

std::string seconds(double value) {
  if (value == 0)
    return "0";
  return std::abs(value) >= 99.5 ? fmt::format("{:.0f}", value) : significant(value, 2);
}

std::string bytes(double value) {
  if (value >= 1e9)
    return fmt::format("{:.1f} GB", value / 1e9);
  return value >= 1e6 ? fmt::format("{:.0f} MB", value / 1e6) : fmt::format("{:.0f} kB", value / 1e3);
}

} // namespace studies
