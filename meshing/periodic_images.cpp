#include "meshing/periodic_images.hpp"

namespace meshing {

namespace {

constexpr double reach = 0.3; // of the radius

/// Calls visit(boxes) for every neighbouring box, not for the box itself.
template <class Visit>
void for_each_neighbour(const pfv::PeriodicAxes& periodic, const Visit& visit) {
  const auto last = [&](std::size_t axis) { return periodic[axis] ? 1 : 0; };
  for (int k = -last(2); k <= last(2); ++k)
    for (int j = -last(1); j <= last(1); ++j)
      for (int i = -last(0); i <= last(0); ++i)
        if (i != 0 || j != 0 || k != 0)
          visit(std::array{i, j, k});
}

pfv::Vec3 along(const std::array<int, 3>& boxes, const pfv::Vec3& size) {
  return pfv::Vec3(boxes[0], boxes[1], boxes[2]).cwiseProduct(size);
}

} // namespace

double distance_to_box(const pfv::Box& box, const pfv::Vec3& point) {
  return (point - point.cwiseMax(box.lower).cwiseMin(box.upper)).norm();
}

pfv::Vec3 ImagedPacking::shift(std::size_t sphere) const {
  return along(boxes[sphere], packing.box.size());
}

ImagedPacking with_images(const pfv::Packing& packing, const pfv::PeriodicAxes& periodic) {
  ImagedPacking result{packing, {}, {}, periodic};
  for (std::size_t k = 0; k < packing.spheres.size(); ++k)
    result.original.push_back(k);
  result.boxes.resize(packing.spheres.size(), {0, 0, 0});
  for (std::size_t k = 0; k < packing.spheres.size(); ++k)
    for_each_neighbour(periodic, [&](const std::array<int, 3>& boxes) {
      const auto& [centre, radius] = packing.spheres[k];
      const pfv::Vec3 image = centre + along(boxes, packing.box.size());
      if (distance_to_box(packing.box, image) >= (1 + reach) * radius)
        return;
      result.packing.spheres.push_back({image, radius});
      result.original.push_back(k);
      result.boxes.push_back(boxes);
    });
  return result;
}

std::vector<pfv::Sphere> all_images(const pfv::Packing& packing, const pfv::PeriodicAxes& periodic) {
  std::vector<pfv::Sphere> spheres = packing.spheres;
  for_each_neighbour(periodic, [&](const std::array<int, 3>& boxes) {
    for (const auto& [centre, radius] : packing.spheres)
      spheres.push_back({centre + along(boxes, packing.box.size()), radius});
  });
  return spheres;
}

} // namespace meshing
