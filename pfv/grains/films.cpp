#include "pfv/grains/films.hpp"

#include "pfv/grains/film_load.hpp"

#include <algorithm>
#include <cmath>

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

Films::Counts Films::add(const Grains& grains, std::span<const Velocity> velocity,
                         const std::array<double, 6>& wall_velocity, const CandidatePairs& pairs,
                         const CandidateWalls& at_walls, const Gaps& gaps, std::vector<Load>& loads,
                         std::array<double, 6>& on_wall) const {
  Counts counts;
  const auto thickness = [&](double gap, double smaller) {
    ++counts.films;
    counts.at_roughness += gap <= gaps.thinnest * smaller;
    return std::clamp(gap, gaps.thinnest * smaller, gaps.thickest * smaller);
  };
  FilmBetween film;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const Sphere a = grains.sphere(i);
    const Velocity of_a = velocity[i];
    Load on_a;
    for (int e = pairs.start[i]; e < pairs.start[i + 1]; ++e) {
      const int j = pairs.other[e];
      const Sphere& b = grains.sphere(j);
      const Vec3 between = apart(pairs, e, a, b);
      const double square = between.squaredNorm(), both = a.radius + b.radius, smaller = std::min(a.radius, b.radius);
      const double reach = both + gaps.reach * smaller;
      if (square >= reach * reach)
        continue;
      const Velocity& of_b = velocity[j];
      const double distance = std::sqrt(square), gap = distance - both;
      const double arm_a = a.radius + 0.5 * gap, arm_b = b.radius + 0.5 * gap;
      film.normal = between / distance;
      film.sliding = of_b.translation - of_a.translation - (arm_a * of_a.spin + arm_b * of_b.spin).cross(film.normal);
      film.spin = of_a.spin - of_b.spin;
      film.radius = 2 * a.radius * b.radius / both;
      film.skew = (a.radius - b.radius) / both;
      const auto [force, couple] = film_load(resistance(film.radius, thickness(gap, smaller)), film);
      const Vec3 turn = film.normal.cross(force);
      on_a.force += force;
      on_a.torque += arm_a * turn + couple;
      loads[j].force -= force;
      loads[j].torque += arm_b * turn - couple;
    }
    loads[i].force += on_a.force;
    loads[i].torque += on_a.torque;
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
      const Velocity& of = velocity[candidate.grain];
      film.sliding = -of.translation - (distance * of.spin).cross(film.normal);
      film.sliding[axis] += wall_velocity[index(face)];
      film.spin = of.spin;
      film.radius = 2 * sphere.radius;
      const auto [force, couple] = film_load(resistance(film.radius, thickness(gap, sphere.radius)), film);
      loads[candidate.grain].force += force;
      loads[candidate.grain].torque += distance * film.normal.cross(force) + couple;
      on_wall[index(face)] -= force[axis];
    }
  }
  return counts;
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
