#pragma once

#include "pfv/grains/candidates.hpp"
#include "pfv/grains/lubrication.hpp"
#include "pfv/grains/walls.hpp"

#include <limits>
#include <span>

namespace pfv {

/// The films of a scene that names lubrication. They remember nothing from step to step but what they did in the last.
class Films {
public:
  Films(const Lubrication& lubrication, std::size_t grains);

  /// Adds what the films do at the velocities the grains have now to their loads, and to `on_wall` (N, along the axis).
  void add_forces(const Grains& grains, const CandidatePairs& pairs, const CandidateWalls& at_walls,
                  std::vector<Load>& loads, std::array<double, 6>& on_wall);

  /// Part of the films in the mean stress of the grains (Pa, compression negative), at the velocities they have now:
  /// sum of force times branch over the volume of the box, as contact_stress. Love (1927), Weber (1966).
  Eigen::Matrix3d stress(const Grains& grains, const CandidatePairs& pairs, const CandidateWalls& at_walls) const;

  /// J that grains and walls lost to the forces of the last add_forces, now that these have acted for `step` seconds.
  double taken(const Grains& grains, double step) const;

  /// Largest eigenvalue (1/s) of M^-1 C, C being the films' damping, by power iteration: a step longer than 2 / it is
  /// unstable. Every candidate counts as if its gap were at the roughness, so that it holds while grains approach; a
  /// grain with none near counts as one at a wall.
  double largest_rate(const Grains& grains, const Walls& walls, const CandidatePairs& pairs,
                      const CandidateWalls& at_walls) const;

  std::size_t count = 0, at_roughness = 0; // in the last add_forces

private:
  /// Which gaps have a film and how thick it is, in shares of the smaller radius.
  struct Gaps {
    double reach, thinnest, thickest = std::numeric_limits<double>::infinity();
  };
  struct Counts {
    std::size_t films = 0, at_roughness = 0;
  };
  struct Motion {
    std::span<const Velocity> grains;
    const std::array<double, 6>& walls; // m/s
  };
  template <class OfPair, class AtWall>
  Counts visit(const Grains& grains, const Motion& motion, const CandidatePairs& pairs, const CandidateWalls& at_walls,
               const Gaps& gaps, const OfPair& of_pair, const AtWall& at_wall) const;
  FilmResistance resistance(double radius, double gap) const;
  double of_lone_film(const Grains& grains) const;
  Counts add(const Grains& grains, std::span<const Velocity> velocity, const std::array<double, 6>& wall_velocity,
             const CandidatePairs& pairs, const CandidateWalls& at_walls, const Gaps& gaps, std::vector<Load>& loads,
             std::array<double, 6>& on_wall) const;
  double power(const Grains& grains) const; // J/s, at the velocities the grains have now

  Lubrication lubrication_;
  FilmResistance acts_; // 1 or 0
  std::vector<Load> loads_;
  std::array<double, 6> on_wall_{};
  double power_at_start_ = 0; // J/s
};

} // namespace pfv
