#include "studies/motion/stability/flip_trials.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"
#include "studies/motion/stability/original.hpp"
#include "studies/motion/stability/steady_trials.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace studies {

using namespace pfv;

namespace {

using Topology = std::multiset<std::array<Vertex, 4>>;

Packing packing_of_ratio(double ratio) {
  return random_packing({.spheres = 80, .solid_fraction = 0.5, .radius_ratio = ratio, .seed = 7});
}

/// One sphere away from the walls, moved along a line by `by` radii.
struct Path {
  double ratio;
  std::size_t sphere;

  Packing at(double by) const {
    Packing packing = packing_of_ratio(ratio);
    Sphere& moving = packing.spheres[sphere];
    moving.centre += by * moving.radius * Vec3(1, 2, 2) / 3;
    return packing;
  }
};

Topology topology(const Packing& packing) {
  Clock clock;
  const PoreNetwork network = build_pore_network(packing, {}, clock);
  Topology pores;
  for (auto vertices : network.pores.vertices) {
    std::ranges::sort(vertices);
    pores.insert(vertices);
  }
  return pores;
}

/// Where on the path, in radii, the triangulation changes for the first time of those that bisection finds.
double flip_on(const Path& path) {
  double before = 0, after = 0.3;
  const Topology start = topology(path.at(before));
  if (topology(path.at(after)) == start)
    throw SolveError("the triangulation does not change on this path");
  while (after - before > 1e-13) {
    const double middle = 0.5 * (before + after);
    (topology(path.at(middle)) == start ? before : after) = middle;
  }
  return 0.5 * (before + after);
}

/// Largest change of the force on a sphere over the rms force.
double jump(const std::vector<Vec3>& before, const std::vector<Vec3>& after, const std::vector<bool>& counts) {
  double largest = 0, square = 0;
  std::size_t number = 0;
  for (std::size_t k = 0; k < before.size(); ++k)
    if (counts[k]) {
      largest = std::max(largest, (after[k] - before[k]).norm());
      square += before[k].squaredNorm();
      ++number;
    }
  return largest / std::sqrt(square / static_cast<double>(number));
}

std::vector<Vec3> forces_at(const Path& path, double by) {
  const SteadyFlow flow = solved(flow_through(path.at(by)));
  std::vector<Vec3> forces;
  for (std::size_t k = 0; k < flow.forces.pressure.size(); ++k)
    forces.push_back(flow.forces.of_flow(k));
  return forces;
}

double our_jump(const Path& path, double flip, double off) {
  const auto before = forces_at(path, flip - off);
  return jump(before, forces_at(path, flip + off), std::vector(before.size(), true));
}

Measured across(const Path& path) {
  const double flip = flip_on(path);
  return {{{"flip at, radii", flip},
           {"jump over 2e-3 radii", our_jump(path, flip, 1e-3)},
           {"over 2e-6", our_jump(path, flip, 1e-6)},
           {"over 2e-9", our_jump(path, flip, 1e-9), 0, 1e-6}}};
}

Theirs theirs_across(const Path& path) {
  const double flip = flip_on(path);
  std::string words;
  for (const double off : {1e-3, 1e-9}) {
    const auto before = ask_original(flow_through(path.at(flip - off)));
    const auto after = before.reply ? ask_original(flow_through(path.at(flip + off))) : before;
    if (!after.reply)
      return {after.why_not};
    words += fmt::format("{}{:.2g} over {:g} radii", words.empty() ? "" : ", ",
                         jump(before.reply->forces, after.reply->forces, away_from_corners(path.at(flip))), 2 * off);
  }
  return {words};
}

} // namespace

std::vector<Trial> flip_trials() {
  std::vector<Trial> trials;
  for (const double ratio : {1.0, 5.0})
    for (const std::size_t sphere : {5u, 23u, 41u}) {
      const Path path{ratio, sphere};
      trials.push_back({"A flip of the triangulation", fmt::format("size ratio {:g}, sphere {}", ratio, sphere),
                        sphere == 5, [=] { return across(path); }, [=] { return theirs_across(path); }});
    }
  return trials;
}

} // namespace studies
