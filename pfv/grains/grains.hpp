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
  Packing packing;         // in the order of the arrays; the walls of the box move too
  PeriodicAxes periodic{}; // along these grains have no walls and leave the box as they like
  std::vector<Velocity> velocity;
  std::vector<double> mass;              // kg
  std::vector<int> number;               // of the sphere in the packing they came from
  std::array<double, 6> wall_velocity{}; // m/s, along the axis, by index(Face)
  double grown = 1;                      // radii over those they began with
  std::vector<double> first_radius;      // m, what these were; empty where none has grown

  std::size_t size() const { return mass.size(); }
  const Sphere& sphere(std::size_t i) const { return packing.spheres[i]; }
  bool is_periodic() const { return periodic[0] || periodic[1] || periodic[2]; }
  /// Of a homogeneous ball (kg m^2).
  double inertia(std::size_t i) const { return 0.4 * mass[i] * sphere(i).radius * sphere(i).radius; }
};

inline double volume(const Sphere& sphere) {
  return 4 * std::numbers::pi / 3 * sphere.radius * sphere.radius * sphere.radius;
}

/// Throws InputError when a periodic box is so narrow that a grain would meet another one twice: as it touches it, or
/// within `reach`, a share of the smaller radius.
void require_wide(const Packing& packing, const PeriodicAxes& periodic, double reach = 0);

/// At rest. Density in kg/m^3, positive. Throws InputError when a periodic box is less than 2.2 diameters of its
/// largest sphere wide, as a grain would then touch another one twice.
Grains grains_of(const Packing& packing, double density, const PeriodicAxes& periodic = {});

/// How far the image of `other` that is nearest to `place` is from it (m).
Vec3 image_offset(const Grains& grains, const Vec3& place, const Vec3& other);

/// How far its image in the box is from a place (m).
Vec3 offset_into_box(const Box& box, const PeriodicAxes& periodic, const Vec3& place);

/// The packing as it is now, its spheres in the order of the one the grains came from, in the box along periodic axes.
Packing packing_of(const Grains& grains);

/// The same, each sphere in its image nearest to where it was before: one that left the box is outside of it.
Packing packing_near(const Grains& grains, const Packing& before);

} // namespace pfv
