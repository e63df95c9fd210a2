#include "pfv/grains/films.hpp"

#include "pfv/grains/film_load.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pfv {

Films::Films(const Lubrication& lubrication, std::size_t grains) : lubrication_(lubrication), loads_(grains) {
  const auto acts = [&](FilmMotion motion) {
    return std::ranges::find(lubrication.resists, motion) != lubrication.resists.end() ? 1.0 : 0.0;
  };
  acts_ = {acts(FilmMotion::normal), acts(FilmMotion::shear), acts(FilmMotion::roll), acts(FilmMotion::twist)};
}

FilmResistance Films::resistance(double radius, double gap) const {
  const FilmResistance all = film_resistance(lubrication_.viscosity, radius, gap);
  return {acts_.normal * all.normal, acts_.shear * all.shear, acts_.roll * all.roll, acts_.twist * all.twist};
}

/// Hands every film to `of_pair(i, j, film, arms, load on i)`, the arms being those of i and j to the middle of the gap
/// (m), or to `at_wall(grain, face, film, arm, load on it)`.
template <class OfPair, class AtWall>
Films::Counts Films::visit(const Grains& grains, const Motion& motion, const CandidatePairs& pairs,
                           const CandidateWalls& at_walls, const Gaps& gaps, const OfPair& of_pair,
                           const AtWall& at_wall) const {
  Counts counts;
  const auto thickness = [&](double gap, double smaller) {
    ++counts.films;
    counts.at_roughness += gap <= gaps.thinnest * smaller;
    return std::clamp(gap, gaps.thinnest * smaller, gaps.thickest * smaller);
  };
  FilmBetween film;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const Sphere a = grains.sphere(i);
    const Velocity of_a = motion.grains[i];
    for (int e = pairs.start[i]; e < pairs.start[i + 1]; ++e) {
      const int j = pairs.other[e];
      const Sphere& b = grains.sphere(j);
      const Vec3 between = apart(pairs, e, a, b);
      const double square = between.squaredNorm(), both = a.radius + b.radius, smaller = std::min(a.radius, b.radius);
      const double reach = both + gaps.reach * smaller;
      if (square >= reach * reach)
        continue;
      const Velocity& of_b = motion.grains[j];
      const double distance = std::sqrt(square), gap = distance - both;
      const double arm_a = a.radius + 0.5 * gap, arm_b = b.radius + 0.5 * gap;
      film.normal = between / distance;
      film.sliding = of_b.translation - of_a.translation - (arm_a * of_a.spin + arm_b * of_b.spin).cross(film.normal);
      film.spin = of_a.spin - of_b.spin;
      film.radius = 2 * a.radius * b.radius / both;
      film.skew = (a.radius - b.radius) / both;
      of_pair(i, j, film, std::pair(arm_a, arm_b), film_load(resistance(film.radius, thickness(gap, smaller)), film));
    }
  }
  const Box& box = grains.packing.box;
  film.skew = -1;
  for (const Face face : all_faces) {
    const int axis = index(axis_of(face));
    const double wall = (is_upper(face) ? box.upper : box.lower)[axis];
    film.normal = outward_normal(face);
    for (const auto& candidate : at_walls.of_face[index(face)]) {
      const Sphere& sphere = grains.sphere(candidate.grain);
      const double distance = (wall - sphere.centre[axis]) * film.normal[axis], gap = distance - sphere.radius;
      if (gap >= gaps.reach * sphere.radius)
        continue;
      const Velocity& of = motion.grains[candidate.grain];
      film.sliding = -of.translation - (distance * of.spin).cross(film.normal);
      film.sliding[axis] += motion.walls[index(face)];
      film.spin = of.spin;
      film.radius = 2 * sphere.radius;
      at_wall(candidate.grain, face, film, distance,
              film_load(resistance(film.radius, thickness(gap, sphere.radius)), film));
    }
  }
  return counts;
}

Films::Counts Films::add(const Grains& grains, std::span<const Velocity> velocity,
                         const std::array<double, 6>& wall_velocity, const CandidatePairs& pairs,
                         const CandidateWalls& at_walls, const Gaps& gaps, std::vector<Load>& loads,
                         std::array<double, 6>& on_wall) const {
  return visit(
      grains, {velocity, wall_velocity}, pairs, at_walls, gaps,
      [&](std::size_t i, int j, const FilmBetween& film, const std::pair<double, double>& arms, const FilmLoad& load) {
        const Vec3 turn = film.normal.cross(load.force);
        loads[i].force += load.force;
        loads[i].torque += arms.first * turn + load.couple;
        loads[j].force -= load.force;
        loads[j].torque += arms.second * turn - load.couple;
      },
      [&](int grain, Face face, const FilmBetween& film, double arm, const FilmLoad& load) {
        loads[grain].force += load.force;
        loads[grain].torque += arm * film.normal.cross(load.force) + load.couple;
        on_wall[index(face)] -= load.force[index(axis_of(face))];
      });
}

Eigen::Matrix3d Films::stress(const Grains& grains, const CandidatePairs& pairs, const CandidateWalls& at_walls) const {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  visit(
      grains, {grains.velocity, grains.wall_velocity}, pairs, at_walls, {lubrication_.reach, lubrication_.roughness},
      [&](std::size_t, int, const FilmBetween& film, const std::pair<double, double>& arms, const FilmLoad& load) {
        sum += (arms.first + arms.second) * film.normal * load.force.transpose();
      },
      [&](int, Face, const FilmBetween& film, double arm, const FilmLoad& load) {
        sum += arm * film.normal * load.force.transpose();
      });
  return sum / grains.packing.box.volume();
}

void Films::add_forces(const Grains& grains, const CandidatePairs& pairs, const CandidateWalls& at_walls,
                       std::vector<Load>& loads, std::array<double, 6>& on_wall) {
  loads_.assign(grains.size(), {});
  on_wall_.fill(0);
  const Counts counts = add(grains, grains.velocity, grains.wall_velocity, pairs, at_walls,
                            {lubrication_.reach, lubrication_.roughness}, loads_, on_wall_);
  count = counts.films;
  at_roughness = counts.at_roughness;
  for (std::size_t i = 0; i < loads_.size(); ++i) {
    loads[i].force += loads_[i].force;
    loads[i].torque += loads_[i].torque;
  }
  for (std::size_t face = 0; face < on_wall.size(); ++face)
    on_wall[face] += on_wall_[face];
  power_at_start_ = power(grains);
}

double Films::power(const Grains& grains) const {
  double power = 0;
  for (std::size_t i = 0; i < loads_.size(); ++i)
    power -= loads_[i].force.dot(grains.velocity[i].translation) + loads_[i].torque.dot(grains.velocity[i].spin);
  for (std::size_t face = 0; face < on_wall_.size(); ++face)
    power -= on_wall_[face] * grains.wall_velocity[face];
  return power;
}

double Films::taken(const Grains& grains, double step) const {
  return 0.5 * step * (power_at_start_ + power(grains));
}

} // namespace pfv
