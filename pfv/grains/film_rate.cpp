#include "pfv/grains/films.hpp"

#include <algorithm>
#include <cmath>

namespace pfv {

/// A sphere at a wall: the normal mode, the trace of sliding and rolling across it, the twist.
double Films::of_lone_film(const Grains& grains) const {
  double largest = 0;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const double radius = grains.sphere(i).radius, square = radius * radius;
    const FilmResistance at_wall = resistance(2 * radius, lubrication_.roughness * radius);
    const double across = 3.5 * (at_wall.shear + 0.25 * at_wall.roll / square);
    largest = std::max(largest, std::max({at_wall.normal, across, 2.5 * at_wall.twist / square}) / grains.mass[i]);
  }
  return largest;
}

double Films::largest_rate(const Grains& grains, const Walls& walls, const CandidatePairs& pairs,
                           const CandidateWalls& at_walls) const {
  constexpr int steps = 60;
  const Gaps closed{std::numeric_limits<double>::infinity(), lubrication_.roughness, lubrication_.roughness};
  std::vector<Velocity> mode(grains.size());
  std::array<double, 6> wall_mode{}, wall_mass{};
  for (std::size_t i = 0; i < mode.size(); ++i) { // a start without symmetry, the same each time
    mode[i].translation = {std::sin(1.0 + i), std::sin(2.0 + 3.0 * i), std::sin(3.0 + 7.0 * i)};
    mode[i].spin =
        Vec3(std::sin(4.0 + 5.0 * i), std::sin(5.0 + 2.0 * i), std::sin(6.0 + 11.0 * i)) / grains.sphere(i).radius;
  }
  for (std::size_t face = 0; face < wall_mass.size(); ++face)
    if (const auto* loaded = std::get_if<LoadedWall>(&walls.motion[face]))
      wall_mass[face] = loaded->mass;

  double rate = 0;
  std::vector<Load> loads;
  for (int step = 0; step < steps; ++step) {
    loads.assign(grains.size(), {});
    std::array<double, 6> on_wall{};
    add(grains, mode, wall_mode, pairs, at_walls, closed, loads, on_wall);
    double dissipated = 0, next = 0;
    for (std::size_t i = 0; i < mode.size(); ++i) {
      const double mass = grains.mass[i], inertia = grains.inertia(i);
      dissipated -= mode[i].translation.dot(loads[i].force) + mode[i].spin.dot(loads[i].torque);
      mode[i] = {loads[i].force / mass, loads[i].torque / inertia};
      next += mass * mode[i].translation.squaredNorm() + inertia * mode[i].spin.squaredNorm();
    }
    for (std::size_t face = 0; face < wall_mass.size(); ++face) {
      if (wall_mass[face] == 0)
        continue;
      dissipated -= wall_mode[face] * on_wall[face];
      wall_mode[face] = on_wall[face] / wall_mass[face];
      next += wall_mass[face] * wall_mode[face] * wall_mode[face];
    }
    if (!(dissipated > 0 && next > 0))
      break;
    rate = next / dissipated; // never below the quotient of this mode
    for (Velocity& of : mode)
      of = {of.translation / std::sqrt(next), of.spin / std::sqrt(next)};
    for (double& of : wall_mode)
      of /= std::sqrt(next);
  }
  return std::max(rate, of_lone_film(grains));
}

} // namespace pfv
