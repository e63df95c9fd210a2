#include "pfv/flow/shear_spread.hpp"

#include <algorithm>
#include <variant>

namespace pfv {
namespace {

Vec3 mirror(Face face, const FaceCondition& condition, const WallRule& walls) {
  const bool slips = std::visit([](const auto& rule) { return rule.surface == 0; }, walls);
  const Vec3 along_normal = Vec3::Unit(index(axis_of(face)));
  if (!std::holds_alternative<SlipWall>(condition))
    return 2 * along_normal - Vec3::Ones();
  return slips ? Vec3(Vec3::Ones() - 2 * along_normal) : Vec3::Ones();
}

/// m^2, what each corner wets of a throat; a wall as much as the spheres do in the mean.
std::array<double, 3> wetted_surfaces(const PoreNetwork& network, std::size_t t, const std::array<Vertex, 3>& corner) {
  std::array<double, 3> wetted{};
  double sum = 0;
  int spheres = 0;
  for (int c = 0; c < 3; ++c)
    if (!is_wall(corner[c])) {
      wetted[c] = std::max(network.throats.wetted_parts[t][c], 0.0F); // below 0 is where facets cut through each other
      sum += wetted[c];
      ++spheres;
    }
  for (int c = 0; c < 3; ++c)
    if (is_wall(corner[c]))
      wetted[c] = spheres > 0 ? sum / spheres : 0;
  return wetted;
}

} // namespace

ShearSpread::ShearSpread(double share, const FaceConditions& faces, const WallRule& walls) : share_(share) {
  for (const Face face : all_faces)
    mirror_[index(face)] = mirror(face, faces[index(face)], walls);
}

Vec3 ShearSpread::behind(Face wall, const Vec3& shear) const {
  return mirror_[index(wall)].cwiseProduct(shear);
}

void ShearSpread::operator()(const PoreNetwork& network, FluidForces& forces) {
  if (share_ == 0)
    return;
  const auto number = [&](Vertex corner) { return network.sites.number[corner]; };
  wetted_.assign(forces.viscous.size(), 0);
  for (std::size_t t = 0; t < network.throats.size(); ++t) {
    const auto corner = network.corners(t);
    const auto wetted = wetted_surfaces(network, t, corner);
    for (int c = 0; c < 3; ++c)
      if (!is_wall(corner[c]))
        wetted_[number(corner[c])] += wetted[c];
  }
  shear_.assign(forces.viscous.size(), Vec3::Zero());
  for (std::size_t k = 0; k < shear_.size(); ++k)
    if (wetted_[k] > 0)
      shear_[k] = forces.viscous[k] / wetted_[k];

  const auto force_on = [&](Vertex corner) -> Vec3& {
    return is_wall(corner) ? forces.on_face[index(face_of(corner))] : forces.viscous[number(corner)];
  };
  const auto shear_at = [&](Vertex corner, Vertex in_front) -> Vec3 {
    return is_wall(corner) ? behind(face_of(corner), shear_[number(in_front)]) : shear_[number(corner)];
  };
  for (std::size_t t = 0; t < network.throats.size(); ++t) {
    const auto corner = network.corners(t);
    const auto wetted = wetted_surfaces(network, t, corner);
    for (int c = 0; c < 3; ++c) {
      const Vertex a = corner[(c + 1) % 3], b = corner[(c + 2) % 3];
      if (is_wall(a) && is_wall(b))
        continue;
      const double weight = 0.5 * share_ * (wetted[(c + 1) % 3] + wetted[(c + 2) % 3] - wetted[c]);
      const Vec3 passed = weight * (shear_at(b, a) - shear_at(a, b));
      force_on(a) += passed;
      force_on(b) -= passed;
    }
  }
}

} // namespace pfv
