#include "reference/lattice_boltzmann/lattice_flow/samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reference::lattice_boltzmann {

namespace {

using Voxel = std::array<int, 3>;

// Into the box, along the axes on which it repeats, and onto it along the others.
pfv::Vec3 into_box(const FlowQuestion& question, pfv::Vec3 point) {
  for (int a = 0; a < 3; ++a) {
    const double size = question.voxels[static_cast<std::size_t>(a)];
    if (question.beyond[static_cast<std::size_t>(a)] == Beyond::repeats)
      point[a] -= size * std::floor(point[a] / size);
    else
      point[a] = std::clamp(point[a], 0.0, size);
  }
  return point;
}

bool in_sphere(const std::vector<SphereImage>& images, const pfv::Vec3& point) {
  for (const auto& [centre, radius, sphere] : images)
    if ((point - centre).squaredNorm() < radius * radius)
      return true;
  return false;
}

// Calls visit(voxel of the box, weight, signs of its image) for the eight centres around a point.
template <typename Visit>
void around(const FlowQuestion& question, const Voxels& voxels, const pfv::Vec3& point, Visit visit) {
  Voxel lower;
  pfv::Vec3 share;
  for (int a = 0; a < 3; ++a) {
    lower[static_cast<std::size_t>(a)] = static_cast<int>(std::floor(point[a] - 0.5));
    share[a] = point[a] - 0.5 - lower[static_cast<std::size_t>(a)];
  }
  for (int corner = 0; corner < 8; ++corner) {
    Voxel voxel = lower;
    pfv::Vec3 of_velocity = pfv::Vec3::Ones();
    double of_pressure = 1;
    double weight = 1;
    for (int a = 0; a < 3; ++a) {
      const auto i = static_cast<std::size_t>(a);
      const bool upper = (corner >> a) & 1;
      voxel[i] += upper;
      weight *= upper ? share[a] : 1 - share[a];
      if (question.beyond[i] == Beyond::repeats || (voxel[i] >= 0 && voxel[i] < question.voxels[i]))
        continue;
      of_velocity[a] = -of_velocity[a];
      if (question.beyond[i] == Beyond::is_opposed) {
        of_velocity = -of_velocity;
        of_pressure = -of_pressure;
      }
    }
    visit(voxels.image(voxel), weight, of_velocity, of_pressure);
  }
}

double flux_through_triangle(const FlowQuestion& question, const Voxels& voxels, const Fields& fields,
                             const std::vector<SphereImage>& images, const std::array<pfv::Vec3, 3>& corners) {
  const pfv::Vec3 e = corners[1] - corners[0];
  const pfv::Vec3 f = corners[2] - corners[0];
  const double longest = std::max({e.norm(), f.norm(), (f - e).norm()});
  const int cuts = std::max(1, static_cast<int>(std::ceil(2 * longest)));
  const pfv::Vec3 area = e.cross(f) / 2 / (static_cast<double>(cuts) * cuts);
  double flux = 0;
  const auto add = [&](double s, double t) {
    const pfv::Vec3 at = into_box(question, corners[0] + s / cuts * e + t / cuts * f);
    if (in_sphere(images, at))
      return;
    around(question, voxels, at, [&](const Voxel& voxel, double weight, const pfv::Vec3& signs, double) {
      const auto i = voxels.index(voxel);
      for (std::size_t a = 0; a < 3; ++a)
        flux += weight * signs[static_cast<int>(a)] * fields.velocity[a][i] * area[static_cast<int>(a)];
    });
  };
  for (int i = 0; i < cuts; ++i)
    for (int j = 0; i + j < cuts; ++j) {
      add(i + 1. / 3, j + 1. / 3);
      if (i + j + 1 < cuts)
        add(i + 2. / 3, j + 2. / 3);
    }
  return flux;
}

} // namespace

std::vector<double> pressures_at_points(const FlowQuestion& question, const Voxels& voxels, const Fields& fields) {
  const auto images = sphere_images(question);
  std::vector<double> pressures;
  for (const auto& point : question.points) {
    const pfv::Vec3 at = into_box(question, point);
    double sum = 0;
    double weights = 0;
    if (!in_sphere(images, at))
      around(question, voxels, at, [&](const Voxel& voxel, double weight, const pfv::Vec3&, double sign) {
        if (!voxels.is_fluid(voxel))
          return;
        sum += weight * sign * fields.pressure[voxels.index(voxel)];
        weights += weight;
      });
    pressures.push_back(weights > 0 ? sum / weights : std::numeric_limits<double>::quiet_NaN());
  }
  return pressures;
}

std::vector<double> fluxes_through_facets(const FlowQuestion& question, const Voxels& voxels, const Fields& fields) {
  const auto images = sphere_images(question);
  std::vector<double> fluxes;
  for (const auto& facet : question.facets) {
    double flux = facet.size() < 3 ? std::numeric_limits<double>::quiet_NaN() : 0;
    for (std::size_t k = 2; k < facet.size(); ++k)
      flux += flux_through_triangle(question, voxels, fields, images, {facet[0], facet[k - 1], facet[k]});
    fluxes.push_back(flux);
  }
  return fluxes;
}

} // namespace reference::lattice_boltzmann
