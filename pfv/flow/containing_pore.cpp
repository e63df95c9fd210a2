#include "pfv/flow/containing_pore.hpp"

#include "pfv/pores/throat_planes.hpp"

#include <algorithm>
#include <limits>

namespace pfv {
namespace {

constexpr int most_layers = 4;

Vec3 moved(const Vec3& point, const Shift& shift, const Box& box) {
  return point + Vec3(shift[0], shift[1], shift[2]).cwiseProduct(box.size());
}

/// How deep the point is in each pore, along the normal of the facet that is nearest: negative outside.
std::vector<double> depths(const PoreNetwork& network, const Vec3& point) {
  const auto& throats = network.throats;
  std::vector<double> depth(network.pores.size(), std::numeric_limits<double>::infinity());
  visit_planes(network, [&](std::size_t t, const ThroatPlane& plane) {
    const auto corners = network.corners(t);
    const Vertex sphere = *std::ranges::find_if_not(corners, is_wall);
    const auto [i, j] = throats.pores[t];
    const Vec3 from_facet = point - network.sites.spheres[sphere].centre;
    const Vec3 as_met_by_j = network.centre_ahead(t) - network.pores.centre[j];
    depth[i] = std::min(depth[i], -plane.normal.dot(from_facet));
    depth[j] = std::min(depth[j], plane.normal.dot(from_facet + as_met_by_j));
  });
  return depth;
}

} // namespace

ContainingPore containing_pore(const PoreNetwork& network, const Vec3& point) {
  const PeriodicAxes periodic = network.periodic();
  const double round_off = 1e-9 * network.box.size().maxCoeff();
  ContainingPore deepest{0, {}};
  double depth = -std::numeric_limits<double>::infinity();
  const auto try_shift = [&](const Shift& shift) {
    const auto found = depths(network, moved(point, shift, network.box));
    const auto best = std::ranges::max_element(found);
    if (*best > depth) {
      depth = *best;
      deepest = {static_cast<int>(best - found.begin()), shift};
    }
  };
  const auto reach = [&](int axis, int layers) { return periodic[axis] ? layers : 0; };
  for (int layers = 0; layers <= most_layers && depth < -round_off; ++layers)
    for (int z = -reach(2, layers); z <= reach(2, layers); ++z)
      for (int y = -reach(1, layers); y <= reach(1, layers); ++y)
        for (int x = -reach(0, layers); x <= reach(0, layers); ++x)
          if (std::max({std::abs(x), std::abs(y), std::abs(z)}) == layers)
            try_shift({static_cast<std::int8_t>(x), static_cast<std::int8_t>(y), static_cast<std::int8_t>(z)});
  return deepest;
}

} // namespace pfv
