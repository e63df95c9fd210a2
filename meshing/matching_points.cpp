#include "meshing/matching_points.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace meshing {

namespace {

using Place = std::array<std::int64_t, 3>;

Place place_of(const pfv::Vec3& point, double side) {
  return {std::llround(point.x() / side), std::llround(point.y() / side), std::llround(point.z() / side)};
}

} // namespace

std::vector<int> matching_points(std::span<const pfv::Vec3> from, std::span<const pfv::Vec3> to, double tolerance) {
  const double side = 4 * tolerance;
  std::map<Place, int> places;
  for (std::size_t i = 0; i < to.size(); ++i)
    places.emplace(place_of(to[i], side), static_cast<int>(i));
  const auto find = [&](const pfv::Vec3& point) {
    for (const double x : {-tolerance, tolerance})
      for (const double y : {-tolerance, tolerance})
        for (const double z : {-tolerance, tolerance}) {
          const auto found = places.find(place_of(point + pfv::Vec3(x, y, z), side));
          if (found != places.end() &&
              (to[static_cast<std::size_t>(found->second)] - point).cwiseAbs().maxCoeff() <= tolerance)
            return found->second;
        }
    return -1;
  };
  std::vector<int> matches;
  matches.reserve(from.size());
  for (const pfv::Vec3& point : from)
    matches.push_back(find(point));
  return matches;
}

} // namespace meshing
