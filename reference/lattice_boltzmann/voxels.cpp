#include "reference/lattice_boltzmann/voxels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reference::lattice_boltzmann {

namespace {

// Coordinates along an axis of a centre and its images across the two faces.
std::array<double, 3> along(double centre, int size, Beyond beyond) {
  if (beyond == Beyond::repeats)
    return {centre, centre - size, centre + size};
  return {centre, -centre, 2 * size - centre};
}

} // namespace

std::vector<SphereImage> sphere_images(const FlowQuestion& question) {
  std::vector<SphereImage> images;
  for (std::size_t k = 0; k < question.spheres.size(); ++k) {
    const auto& [centre, radius] = question.spheres[k];
    std::array<std::vector<double>, 3> places;
    for (std::size_t a = 0; a < 3; ++a)
      for (const double x : along(centre[static_cast<int>(a)], question.voxels[a], question.beyond[a]))
        if (x + radius >= -1 && x - radius <= question.voxels[a] + 1 && std::ranges::count(places[a], x) == 0)
          places[a].push_back(x);
    for (const double x : places[0])
      for (const double y : places[1])
        for (const double z : places[2])
          images.push_back({{x, y, z}, radius, static_cast<std::int32_t>(k)});
  }
  return images;
}

Voxels::Voxels(const FlowQuestion& question) : size_(question.voxels), beyond_(question.beyond) {
  const auto count = index({size_[0] - 1, size_[1] - 1, size_[2] - 1}) + 1;
  owner_.assign(count, fluid);
  // Squared distance less squared radius, kept only while voxels are filled.
  std::vector<float> power(count, std::numeric_limits<float>::max());
  for (const auto& [centre, radius, sphere] : sphere_images(question)) {
    std::array<int, 3> first;
    std::array<int, 3> last;
    for (std::size_t a = 0; a < 3; ++a) {
      const double x = centre[static_cast<int>(a)];
      first[a] = std::max(0, static_cast<int>(std::ceil(x - radius - 0.5)));
      last[a] = std::min(size_[a] - 1, static_cast<int>(std::floor(x + radius - 0.5)));
    }
    for (int x = first[0]; x <= last[0]; ++x)
      for (int y = first[1]; y <= last[1]; ++y)
        for (int z = first[2]; z <= last[2]; ++z) {
          const double here = (pfv::Vec3(x + 0.5, y + 0.5, z + 0.5) - centre).squaredNorm() - radius * radius;
          const auto at = index({x, y, z});
          if (here <= 0 && static_cast<float>(here) < power[at]) {
            power[at] = static_cast<float>(here);
            owner_[at] = sphere;
          }
        }
  }
}

bool Voxels::inside(const std::array<int, 3>& voxel) const {
  for (std::size_t a = 0; a < 3; ++a)
    if (voxel[a] < 0 || voxel[a] >= size_[a])
      return false;
  return true;
}

std::array<int, 3> Voxels::image(std::array<int, 3> voxel) const {
  for (std::size_t a = 0; a < 3; ++a)
    if (beyond_[a] == Beyond::repeats)
      voxel[a] = (voxel[a] + size_[a]) % size_[a];
    else if (voxel[a] < 0)
      voxel[a] = -1 - voxel[a];
    else if (voxel[a] >= size_[a])
      voxel[a] = 2 * size_[a] - 1 - voxel[a];
  return voxel;
}

std::size_t Voxels::fluid_count() const {
  return static_cast<std::size_t>(std::ranges::count(owner_, fluid));
}

std::vector<double> Voxels::solid_counts(std::size_t spheres) const {
  std::vector<double> counts(spheres, 0);
  for (const std::int32_t sphere : owner_)
    if (sphere != fluid)
      ++counts[static_cast<std::size_t>(sphere)];
  return counts;
}

} // namespace reference::lattice_boltzmann
