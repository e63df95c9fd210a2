#include "meshing/mesher/surface_names.hpp"

#include "pfv/problem/face.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace mesher {

namespace {

constexpr double tolerance = 1e-7; // of the radius or the box side

/// Between the ends too: bridges of one sphere can have one axis.
bool is_on(const meshing::Bridge& bridge, const pfv::Vec3& point) {
  const pfv::Vec3 axis = bridge.to - bridge.from;
  const pfv::Vec3 offset = point - bridge.from;
  const double along = offset.dot(axis) / axis.squaredNorm();
  return along > 0 && along < 1 && std::abs((offset - along * axis).norm() - bridge.radius) < tolerance * bridge.radius;
}

} // namespace

std::string name_of_surface(const std::vector<pfv::Vec3>& points, const pfv::Packing& packing,
                            const std::vector<meshing::Bridge>& bridges) {
  const auto all = [&](auto is_on_it) { return std::ranges::all_of(points, is_on_it); };
  std::vector<std::string> names;
  for (std::size_t k = 0; k < packing.spheres.size(); ++k) {
    const auto& [centre, radius] = packing.spheres[k];
    if (all([&](const pfv::Vec3& point) { return std::abs((point - centre).norm() - radius) < tolerance * radius; }))
      names.push_back(fmt::format("sphere_{}", k));
  }
  for (const meshing::Bridge& bridge : bridges)
    if (all([&](const pfv::Vec3& point) { return is_on(bridge, point); }))
      names.push_back(bridge.name);
  for (const pfv::Face face : pfv::all_faces) {
    const int axis = pfv::index(pfv::axis_of(face));
    const double plane = (pfv::is_upper(face) ? packing.box.upper : packing.box.lower)[axis];
    const double scale = packing.box.size()[axis];
    if (all([&](const pfv::Vec3& point) { return std::abs(point[axis] - plane) < tolerance * scale; }))
      names.emplace_back(pfv::face_names[pfv::index(face)]);
  }
  if (names.size() != 1)
    throw std::runtime_error(fmt::format(
        "a surface through ({:g}, {:g}, {:g}) lies on {}", points.at(0).x(), points.at(0).y(), points.at(0).z(),
        names.empty() ? "no sphere, bridge or face" : fmt::format("{}", fmt::join(names, " and "))));
  return names.front();
}

} // namespace mesher
