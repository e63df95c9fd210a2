#include "meshing/disc_union.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace meshing {

namespace {

struct Interval {
  double begin, end;
};

constexpr double full_turn = 2 * std::numbers::pi;

/// Parts of a circle, as angles within (0, 2 pi).
class Angles {
public:
  /// The angles within `half_width` of `middle`.
  void add(double middle, double half_width) {
    if (half_width <= 0)
      return;
    double begin = std::fmod(middle - half_width, full_turn);
    if (begin < 0)
      begin += full_turn;
    const double end = begin + std::min(2 * half_width, full_turn);
    parts_.push_back({begin, std::min(end, full_turn)});
    if (end > full_turn)
      parts_.push_back({0, end - full_turn});
  }

  /// What is not covered by any part.
  std::vector<Interval> gaps() {
    std::ranges::sort(parts_, {}, &Interval::begin);
    std::vector<Interval> result;
    double covered = 0;
    for (const auto& [begin, end] : parts_) {
      if (begin > covered)
        result.push_back({covered, begin});
      covered = std::max(covered, end);
    }
    if (covered < full_turn)
      result.push_back({covered, full_turn});
    return result;
  }

private:
  std::vector<Interval> parts_;
};

/// Half the angle of a circle that lies beyond a line at `distance` from its centre.
double half_angle_beyond(double distance, double radius) {
  return std::acos(std::clamp(distance / radius, -1.0, 1.0));
}

/// Half the angle of disc `a`'s circle that lies in disc `b`.
double half_angle_inside(const Disc& a, const Disc& b, double distance) {
  if (distance >= a.radius + b.radius)
    return 0;
  if (distance <= std::abs(a.radius - b.radius))
    return a.radius < b.radius ? std::numbers::pi : 0;
  return half_angle_beyond((distance * distance + a.radius * a.radius - b.radius * b.radius) / (2 * distance),
                           a.radius);
}

/// Length of (0, width) within `half` of any of the middles.
double covered_length(std::vector<Interval> parts, double width) {
  std::ranges::sort(parts, {}, &Interval::begin);
  double length = 0, covered = 0;
  for (const auto& [begin, end] : parts) {
    const double from = std::max(begin, covered);
    const double to = std::min(end, width);
    if (to > from) {
      length += to - from;
      covered = to;
    }
  }
  return length;
}

} // namespace

DiscUnion disc_union(std::span<const Disc> discs, double width_y, double width_z) {
  DiscUnion result;
  std::vector<Interval> upper_y, upper_z; // covered parts of the two edges that do not pass through the origin
  for (const Disc& disc : discs) {
    const auto& [y, z, r, weight] = disc;
    Angles hidden;
    hidden.add(0, half_angle_beyond(width_y - y, r));
    hidden.add(std::numbers::pi / 2, half_angle_beyond(width_z - z, r));
    hidden.add(std::numbers::pi, half_angle_beyond(y, r));
    hidden.add(3 * std::numbers::pi / 2, half_angle_beyond(z, r));
    for (const Disc& other : discs)
      if (&other != &disc)
        hidden.add(std::atan2(other.z - z, other.y - y),
                   half_angle_inside(disc, other, std::hypot(other.y - y, other.z - z)));
    for (const auto& [begin, end] : hidden.gaps()) {
      result.arcs += weight * (end - begin);
      result.area +=
          r / 2 * (r * (end - begin) + y * (std::sin(end) - std::sin(begin)) - z * (std::cos(end) - std::cos(begin)));
    }
    if (const double offset = width_y - y; std::abs(offset) < r) {
      const double half = std::sqrt(r * r - offset * offset);
      upper_y.push_back({z - half, z + half});
    }
    if (const double offset = width_z - z; std::abs(offset) < r) {
      const double half = std::sqrt(r * r - offset * offset);
      upper_z.push_back({y - half, y + half});
    }
  }
  result.area += (width_y * covered_length(upper_y, width_z) + width_z * covered_length(upper_z, width_y)) / 2;
  return result;
}

} // namespace meshing
