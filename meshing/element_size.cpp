#include "meshing/element_size.hpp"

#include "pfv/problem/face.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace meshing {

namespace {

/// The spheres and their images in the six faces; an image that falls on its own sphere is the same surface.
std::vector<pfv::Sphere> with_mirror_images(const pfv::Packing& packing) {
  std::vector<pfv::Sphere> surfaces = packing.spheres;
  for (const auto& [centre, radius] : packing.spheres)
    for (const pfv::Face face : pfv::all_faces) {
      const int axis = pfv::index(pfv::axis_of(face));
      const double plane = (pfv::is_upper(face) ? packing.box.upper : packing.box.lower)[axis];
      if (std::abs(plane - centre[axis]) < 1e-6 * radius)
        continue;
      pfv::Vec3 image = centre;
      image[axis] = 2 * plane - centre[axis];
      surfaces.push_back({image, radius});
    }
  return surfaces;
}

double distance_to(const pfv::Sphere& surface, const pfv::Vec3& point) {
  return std::max(0.0, (point - surface.centre).norm() - surface.radius);
}

} // namespace

ElementSize::ElementSize(const pfv::Packing& packing, double mesh_size)
    : mesh_size_(mesh_size), lower_(packing.box.lower), surfaces_(with_mirror_images(packing)) {
  const double spacing = std::cbrt(packing.box.volume() / (8.0 * static_cast<double>(packing.spheres.size())));
  for (int a = 0; a < 3; ++a) {
    cells_[a] = std::clamp(static_cast<int>(packing.box.size()[a] / spacing), 1, 64);
    cell_size_[a] = packing.box.size()[a] / cells_[a];
  }
  const double half_diagonal = cell_size_.norm() / 2;
  std::vector<double> distances(surfaces_.size());
  for (int z = 0; z < cells_[2]; ++z)
    for (int y = 0; y < cells_[1]; ++y)
      for (int x = 0; x < cells_[0]; ++x) {
        const pfv::Vec3 middle = lower_ + cell_size_.cwiseProduct(pfv::Vec3(x + 0.5, y + 0.5, z + 0.5));
        std::ranges::transform(surfaces_, distances.begin(),
                               [&](const pfv::Sphere& surface) { return distance_to(surface, middle); });
        std::vector<double> nearest = distances;
        const std::size_t second = std::min<std::size_t>(1, nearest.size() - 1);
        std::ranges::nth_element(nearest, nearest.begin() + static_cast<std::ptrdiff_t>(second));
        std::vector<int>& kept = cell_surfaces_.emplace_back();
        for (std::size_t s = 0; s < surfaces_.size(); ++s)
          if (distances[s] <= nearest[second] + 2 * half_diagonal)
            kept.push_back(static_cast<int>(s));
      }
}

const std::vector<int>& ElementSize::candidates(const pfv::Vec3& point) const {
  std::array<int, 3> cell{};
  for (int a = 0; a < 3; ++a)
    cell[a] = std::clamp(static_cast<int>((point[a] - lower_[a]) / cell_size_[a]), 0, cells_[a] - 1);
  return cell_surfaces_[static_cast<std::size_t>((cell[2] * cells_[1] + cell[1]) * cells_[0] + cell[0])];
}

double ElementSize::operator()(const pfv::Vec3& point) const {
  struct Near {
    double distance = std::numeric_limits<double>::infinity();
    double radius = std::numeric_limits<double>::infinity();
  };
  Near first, second;
  for (const int s : candidates(point)) {
    const Near here{distance_to(surfaces_[s], point), surfaces_[s].radius};
    if (here.distance < first.distance)
      second = std::exchange(first, here);
    else if (here.distance < second.distance)
      second = here;
  }
  const double cap =
      std::min(largest * first.radius + growth * first.distance, largest * second.radius + growth * second.distance);
  const double floor = smallest * std::min(first.radius, second.radius);
  return mesh_size_ * std::min(cap, std::max(floor, gap_fraction * (first.distance + second.distance)));
}

} // namespace meshing
