#pragma once

#include "pfv/grains/grains.hpp"
#include "pfv/problem/case.hpp"

#include <string_view>
#include <variant>
#include <vector>

namespace pfv {

// Forces on every grain by itself. A further one is one more struct with its two functions here and one more word in
// the variant: scenes then have its table, `pfv run` names it and its work is counted. See ADDING_AN_EFFECT.md.

struct Gravity {
  static constexpr std::string_view name = "gravity"; // of its table in a scene
  static constexpr bool changes = false;              // with time, place or velocity: is evaluated in every step
  Vec3 acceleration = Vec3::Zero();                   // m/s^2

  bool operator==(const Gravity&) const = default;
};

/// N, on grain i at a time (s): m g.
inline Vec3 force(const Gravity& gravity, const Grains& grains, std::size_t i, double) {
  return grains.mass[i] * gravity.acceleration;
}

/// The keys of its table, all of which must be there.
void for_each_key(Gravity& gravity, const auto& key) {
  key("acceleration", gravity.acceleration, "m/s^2");
}

/// That of a case, as grains in motion feel it.
struct BuoyancyOfGrains : Buoyancy {
  static constexpr std::string_view name = "buoyancy";
  static constexpr bool changes = false;

  bool operator==(const BuoyancyOfGrains&) const = default;
};

/// N: - rho_f g V.
inline Vec3 force(const BuoyancyOfGrains& buoyancy, const Grains& grains, std::size_t i, double) {
  return -(buoyancy.fluid_density * volume(grains.sphere(i)) * buoyancy.gravity);
}

void for_each_key(BuoyancyOfGrains& buoyancy, const auto& key) {
  key("fluid_density", buoyancy.fluid_density, "kg/m^3");
  key("gravity", buoyancy.gravity, "m/s^2");
}

using BodyForce = std::variant<Gravity, BuoyancyOfGrains>;

/// N, of all of them, by grain; empty without any.
inline std::vector<Vec3> sum_of(const std::vector<BodyForce>& forces, const Grains& grains, double time) {
  std::vector<Vec3> sum(forces.empty() ? 0 : grains.size(), Vec3::Zero());
  for (const BodyForce& one : forces)
    std::visit(
        [&](const auto& is) {
          for (std::size_t i = 0; i < grains.size(); ++i)
            sum[i] += force(is, grains, i, time);
        },
        one);
  return sum;
}

/// Whether any of them is another one in the next step.
inline bool changes(const std::vector<BodyForce>& forces) {
  for (const BodyForce& one : forces)
    if (std::visit([](const auto& is) { return is.changes; }, one))
      return true;
  return false;
}

} // namespace pfv
