#include "studies/runner/colours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace studies {

namespace {

template <std::size_t n>
Colour between(const std::array<Colour, n>& stops, double share) {
  const double at = std::clamp(share, 0.0, 1.0) * (n - 1);
  const auto i = std::min<std::size_t>(static_cast<std::size_t>(at), n - 2);
  const double t = at - static_cast<double>(i);
  const auto mix = [&](double a, double b) { return a + t * (b - a); };
  return {mix(stops[i].red, stops[i + 1].red), mix(stops[i].green, stops[i + 1].green),
          mix(stops[i].blue, stops[i + 1].blue)};
}

} // namespace

Colour colour_of(double share) {
  static constexpr std::array<Colour, 5> stops{
      {{72, 40, 120}, {62, 84, 150}, {38, 140, 140}, {100, 190, 90}, {240, 220, 70}}};
  return between(stops, share);
}

Colour diverging_colour_of(double share) {
  static constexpr std::array<Colour, 5> stops{
      {{30, 70, 150}, {110, 160, 210}, {236, 236, 232}, {225, 140, 100}, {160, 35, 40}}};
  return between(stops, (share + 1) / 2);
}

std::string lit(const Colour& colour, double light) {
  const auto byte = [&](double value) {
    return static_cast<int>(light > 1 ? value + (255 - value) * (light - 1) : value * light);
  };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(colour.red), byte(colour.green), byte(colour.blue));
}

} // namespace studies
