#include "meshing/mesher/seams.hpp"

#include "meshing/mesher/circles_on_spheres.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace mesher {

namespace {

using Eigen::Quaterniond;
using pfv::Vec3;

constexpr double pi = std::numbers::pi;
constexpr double far = std::numeric_limits<double>::infinity();

/// Numbers within (0, 1) that are the same on every machine.
class Uniform {
public:
  explicit Uniform(std::uint64_t seed) : random_(seed) {}
  double operator()() { return (static_cast<double>(random_() >> 11) + 0.5) * 0x1p-53; }

private:
  std::mt19937_64 random_;
};

/// Shoemake 1992, Uniform random rotations.
Quaterniond random_turn(Uniform& uniform) {
  const double u = uniform(), v = 2 * pi * uniform(), w = 2 * pi * uniform();
  return {std::sqrt(1 - u) * std::sin(v), std::sqrt(1 - u) * std::cos(v), std::sqrt(u) * std::sin(w),
          std::sqrt(u) * std::cos(w)};
}

/// Smallest angle by which the seam and the poles of a turned sphere keep clear of a circle, for small circles in units
/// of their size.
double clearance(const Quaterniond& turn, const Circle& circle) {
  const Vec3 local = turn.conjugate() * circle.axis;
  const double to_pole = std::acos(std::clamp(std::abs(local.z()), 0.0, 1.0));
  const double to_seam = local.x() >= 0 ? std::asin(std::clamp(std::abs(local.y()), 0.0, 1.0)) : to_pole;
  const double size = circle.angle == 0 ? 0.2 : std::min({0.2, circle.angle, pi - circle.angle});
  return std::min({std::abs(to_seam - circle.angle), std::abs(to_pole - circle.angle),
                   std::abs(pi - to_pole - circle.angle)}) /
         std::max(size, 1e-3);
}

Quaterniond best_turn(const Circles& circles, Uniform& uniform) {
  constexpr int draws = 1000;
  Quaterniond best;
  double widest = -1;
  for (int draw = 0; draw < draws; ++draw) {
    const Quaterniond turn = random_turn(uniform);
    double least = far;
    for (const Circle& circle : circles) {
      least = std::min(least, clearance(turn, circle));
      if (least <= widest)
        break;
    }
    if (least > widest) {
      widest = least;
      best = turn;
    }
  }
  return best;
}

/// Angles around a bridge's axis, in its own frame, at which the seam of a turned sphere crosses the bridge's circle.
void add_seam_crossings(const pfv::Sphere& sphere, const Quaterniond& sphere_turn, const meshing::Bridge& bridge,
                        const Quaterniond& frame, std::vector<double>& angles) {
  constexpr int steps = 2000;
  double previous = 0;
  for (int i = 0; i <= steps; ++i) {
    const double latitude = pi * (static_cast<double>(i) / steps - 0.5);
    const Vec3 point = sphere.centre + sphere.radius * (sphere_turn * Vec3(std::cos(latitude), 0, std::sin(latitude)));
    const Vec3 local = frame.conjugate() * (point - bridge.from);
    const double beyond = local.head<2>().norm() - bridge.radius;
    const double length = (bridge.to - bridge.from).norm();
    if (i > 0 && beyond * previous < 0 && local.z() > 0 && local.z() < length)
      angles.push_back(std::atan2(local.y(), local.x()));
    previous = beyond;
  }
}

/// Distance in radii between a bridge's seam at `angle` and the box faces that the bridge lies in.
double distance_to_faces(const meshing::Bridge& bridge, const Quaterniond& frame, double angle, const pfv::Box& box) {
  double least = far;
  for (const Vec3& end : {bridge.from, bridge.to})
    for (int a = 0; a < 3; ++a)
      for (const double plane : {box.lower[a], box.upper[a]}) {
        const Vec3 offset = frame * Vec3(std::cos(angle), std::sin(angle), 0);
        const bool lies_in = std::abs((frame * Vec3::UnitZ())[a]) < 0.5;
        if (lies_in && std::abs(end[a] - plane) < 2 * bridge.radius)
          least = std::min(least, std::abs(end[a] + bridge.radius * offset[a] - plane) / bridge.radius);
      }
  return least;
}

/// Whether two bridges are the same one in different boxes.
bool are_images(const meshing::Bridge& a, const meshing::Bridge& b, const meshing::ImagedPacking& imaged) {
  Vec3 apart = b.from - a.from;
  const Vec3 size = imaged.packing.box.size();
  for (int axis = 0; axis < 3; ++axis)
    if (imaged.periodic[static_cast<std::size_t>(axis)])
      apart[axis] = std::remainder(apart[axis], size[axis]);
  return apart.norm() < 1e-9 * a.radius && ((b.to - b.from) - (a.to - a.from)).norm() < 1e-9 * a.radius;
}

/// The turn of a bridge and of its images.
Quaterniond best_turn(const std::vector<meshing::Bridge>& images, const pfv::Packing& packing,
                      const std::vector<Quaterniond>& spheres, Uniform& uniform) {
  const Quaterniond frame = Quaterniond::FromTwoVectors(Vec3::UnitZ(), images[0].to - images[0].from);
  std::vector<double> taken;
  for (const meshing::Bridge& bridge : images)
    for (std::size_t k = 0; k < spheres.size(); ++k) {
      const auto& sphere = packing.spheres[k];
      if (std::min((sphere.centre - bridge.from).norm(), (sphere.centre - bridge.to).norm()) < sphere.radius)
        add_seam_crossings(sphere, spheres[k], bridge, frame, taken);
    }
  constexpr int draws = 100;
  const double start = 2 * pi * uniform();
  double best = start, widest = -1;
  for (int draw = 0; draw < draws; ++draw) {
    const double angle = start + 2 * pi * draw / draws;
    double least = 0.7;
    for (const meshing::Bridge& bridge : images)
      least = std::min(least, distance_to_faces(bridge, frame, angle, packing.box));
    for (const double other : taken)
      least = std::min(least, std::abs(std::remainder(angle - other, 2 * pi)));
    if (least > widest) {
      widest = least;
      best = angle;
    }
  }
  return frame * Eigen::AngleAxisd(best, Vec3::UnitZ());
}

} // namespace

Turns turns_of_seams(const meshing::ImagedPacking& imaged, const std::vector<meshing::Bridge>& bridges,
                     std::uint64_t attempt) {
  Uniform uniform(attempt);
  Turns turns;
  const pfv::Packing& packing = imaged.packing;
  std::vector<Circles> circles = circles_on_spheres(packing, bridges);
  for (std::size_t k = 0; k < circles.size(); ++k)
    if (Circles& of_original = circles[imaged.original[k]]; &of_original != &circles[k])
      of_original.insert(of_original.end(), circles[k].begin(), circles[k].end());
  for (std::size_t k = 0; k < circles.size(); ++k)
    turns.spheres.push_back(imaged.original[k] == k ? best_turn(circles[k], uniform)
                                                    : turns.spheres[imaged.original[k]]);
  std::vector<bool> is_turned(bridges.size(), false);
  turns.bridges.resize(bridges.size());
  for (std::size_t b = 0; b < bridges.size(); ++b) {
    if (is_turned[b])
      continue;
    std::vector<meshing::Bridge> images;
    std::vector<std::size_t> alike;
    for (std::size_t other = b; other < bridges.size(); ++other)
      if (are_images(bridges[b], bridges[other], imaged)) {
        images.push_back(bridges[other]);
        alike.push_back(other);
      }
    const Quaterniond best = best_turn(images, packing, turns.spheres, uniform);
    for (const std::size_t other : alike) {
      turns.bridges[other] = best;
      is_turned[other] = true;
    }
  }
  return turns;
}

} // namespace mesher
