#include "reference/cut_spheres.hpp"

#include "pfv/pores/disc_part.hpp"
#include "pfv/pores/wall_distance.hpp"

#include <cmath>

namespace reference {

namespace {

std::size_t slot(pfv::Face face) {
  return static_cast<std::size_t>(pfv::index(face));
}

} // namespace

double cut_area(const pfv::Sphere& sphere, pfv::Face face, const pfv::Box& box) {
  const double distance = pfv::wall_distance(box, face, sphere.centre);
  if (distance >= sphere.radius)
    return 0;
  const pfv::Vec3 normal = pfv::outward_normal(face);
  const pfv::Sphere disc{sphere.centre + distance * normal,
                         std::sqrt(sphere.radius * sphere.radius - distance * distance)};
  std::vector<pfv::WallCut> others;
  for (const auto& cut : pfv::wall_cuts(disc, box))
    if (std::abs(cut.outward.dot(normal)) < 0.5)
      others.push_back(cut);
  const pfv::Vec3 u = pfv::Vec3::Unit((pfv::index(pfv::axis_of(face)) + 1) % 3);
  const pfv::Vec3 v = normal.cross(u);
  return pfv::disc_in_wedge(disc.radius, others, u, v) + pfv::disc_in_wedge(disc.radius, others, v, -u) +
         pfv::disc_in_wedge(disc.radius, others, -u, -v) + pfv::disc_in_wedge(disc.radius, others, -v, u);
}

void add_pressure_on_discs(const pfv::Case& problem, std::vector<pfv::Vec3>& on_spheres,
                           std::array<pfv::Vec3, 6>& on_faces) {
  for (const pfv::Face face : pfv::all_faces) {
    const auto* open = std::get_if<pfv::Pressure>(&problem.faces[slot(face)]);
    if (!open)
      continue;
    for (std::size_t k = 0; k < on_spheres.size(); ++k) {
      const pfv::Vec3 push =
          open->value * cut_area(problem.packing.spheres[k], face, problem.packing.box) * pfv::outward_normal(face);
      on_spheres[k] -= push;
      on_faces[slot(face)] += push;
    }
  }
}

void give_normal_parts_to_slip_walls(const pfv::Case& problem, std::vector<pfv::Vec3>& on_spheres,
                                     std::array<pfv::Vec3, 6>& on_faces) {
  for (const pfv::Face face : pfv::all_faces) {
    if (!std::holds_alternative<pfv::SlipWall>(problem.faces[slot(face)]))
      continue;
    const int axis = pfv::index(pfv::axis_of(face));
    for (std::size_t k = 0; k < on_spheres.size(); ++k) {
      const pfv::Sphere& sphere = problem.packing.spheres[k];
      if (std::abs(pfv::wall_distance(problem.packing.box, face, sphere.centre)) > 1e-9 * sphere.radius)
        continue;
      on_faces[slot(face)][axis] += on_spheres[k][axis];
      on_spheres[k][axis] = 0;
    }
  }
}

void drop_normal_parts_at_slip_walls(const pfv::Case& problem, std::vector<pfv::Vec3>& on_spheres) {
  std::array<pfv::Vec3, 6> dropped;
  dropped.fill(pfv::Vec3::Zero());
  give_normal_parts_to_slip_walls(problem, on_spheres, dropped);
}

} // namespace reference
