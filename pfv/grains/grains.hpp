#pragma once

#include "pfv/problem/packing.hpp"

#include <array>
#include <cstddef>
#include <numbers>
#include <vector>

namespace pfv {

struct Velocity {
  Vec3 translation = Vec3::Zero(); // m/s
  Vec3 spin = Vec3::Zero();        // rad/s

  bool operator==(const Velocity&) const = default;
};

struct Load {
  Vec3 force = Vec3::Zero();  // N
  Vec3 torque = Vec3::Zero(); // N m, about the centre
};

/// Rigid spheres in motion, in flat arrays. They come bar by bar, as sites_of sorts them, so that what touches is near
/// in memory. Positions are those of a time step, velocities those of half a step before.
struct Grains {
  Packing packing; // in the order of the arrays; the walls of the box move too
  std::vector<Velocity> velocity;
  std::vector<double> mass;              // kg
  std::vector<int> number;               // of the sphere in the packing they came from
  std::array<double, 6> wall_velocity{}; // m/s, along the axis, by index(Face)

  std::size_t size() const { return mass.size(); }
  const Sphere& sphere(std::size_t i) const { return packing.spheres[i]; }
  /// Of a homogeneous ball (kg m^2).
  double inertia(std::size_t i) const { return 0.4 * mass[i] * sphere(i).radius * sphere(i).radius; }
};

inline double volume(const Sphere& sphere) {
  return 4 * std::numbers::pi / 3 * sphere.radius * sphere.radius * sphere.radius;
}

/// At rest. Density in kg/m^3, positive.
Grains grains_of(const Packing& packing, double density);

/// The packing as it is now, its spheres in the order of the one the grains came from.
Packing packing_of(const Grains& grains);

} // namespace pfv
