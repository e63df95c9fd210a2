#include "reference/lattice_boltzmann/wall_links.hpp"

#include "reference/lattice_boltzmann/velocities.hpp"

#include <algorithm>
#include <cmath>

namespace reference::lattice_boltzmann {

namespace {

using Voxel = std::array<int, 3>;

Voxel moved(const Voxel& voxel, const Step& step, int times) {
  return {voxel[0] + times * step[0], voxel[1] + times * step[1], voxel[2] + times * step[2]};
}

pfv::Vec3 centre_of(const Voxel& voxel) {
  return {voxel[0] + 0.5, voxel[1] + 0.5, voxel[2] + 0.5};
}

// Where on the way from a point outside, by a step that ends inside, the sphere begins.
double entry(const pfv::Vec3& from, const Step& step, const SphereImage& image) {
  const pfv::Vec3 way(step[0], step[1], step[2]);
  const pfv::Vec3 off = from - image.centre;
  const double a = way.squaredNorm();
  const double b = way.dot(off);
  const double c = std::max(0.0, off.squaredNorm() - image.radius * image.radius);
  return std::clamp((-b - std::sqrt(std::max(0.0, b * b - a * c))) / a, 0.0, 1.0);
}

void add_links(const SphereImage& image, const Voxels& voxels, std::vector<WallLink>& links) {
  Voxel first;
  Voxel last;
  for (std::size_t a = 0; a < 3; ++a) {
    const double x = image.centre[static_cast<int>(a)];
    first[a] = std::max(-1, static_cast<int>(std::ceil(x - image.radius - 0.5)));
    last[a] = std::min(voxels.size()[a], static_cast<int>(std::floor(x + image.radius - 0.5)));
  }
  const double core = std::max(0.0, image.radius - 1.5); // no step out of it leaves the sphere
  for (int x = first[0]; x <= last[0]; ++x)
    for (int y = first[1]; y <= last[1]; ++y)
      for (int z = first[2]; z <= last[2]; ++z) {
        const Voxel end{x, y, z};
        const double distance = (centre_of(end) - image.centre).norm();
        if (distance > image.radius || distance < core)
          continue;
        for (std::size_t d = 1; d < directions; ++d) {
          const Voxel voxel = moved(end, steps[d], -1);
          if (voxels.inside(voxel) && voxels.is_fluid(voxel))
            links.push_back({voxel, static_cast<std::int32_t>(d), image.sphere,
                             !voxels.is_fluid(voxels.image(moved(voxel, steps[d], -1))),
                             entry(centre_of(voxel), steps[d], image)});
        }
      }
}

} // namespace

std::vector<WallLink> wall_links(const FlowQuestion& question, const Voxels& voxels) {
  std::vector<WallLink> links;
  for (const SphereImage& image : sphere_images(question))
    add_links(image, voxels, links);
  // Where several spheres or images stand in the way, the first one met counts.
  const auto place = [&](const WallLink& link) {
    return voxels.index(link.voxel) * directions + static_cast<std::size_t>(link.direction);
  };
  std::ranges::sort(links, [&](const WallLink& a, const WallLink& b) {
    return std::pair(place(a), a.fraction) < std::pair(place(b), b.fraction);
  });
  const auto repeated = std::ranges::unique(links, {}, place);
  links.erase(repeated.begin(), repeated.end());
  return links;
}

std::array<double, 3> on_sphere_inside(const FlowQuestion& question, const WallLink& link,
                                       std::array<double, 3> momentum) {
  if (link.fraction <= 0.5)
    return momentum;
  const Step& step = steps[static_cast<std::size_t>(link.direction)];
  for (std::size_t a = 0; a < 3; ++a) {
    const int end = link.voxel[a] + step[a];
    if (question.beyond[a] == Beyond::repeats || (end >= 0 && end < question.voxels[a]))
      continue;
    momentum[a] = -momentum[a];
    if (question.beyond[a] == Beyond::is_opposed)
      for (double& component : momentum)
        component = -component;
  }
  return momentum;
}

} // namespace reference::lattice_boltzmann
