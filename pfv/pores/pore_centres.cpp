#include "pfv/pores/pore_centres.hpp"

#include "pfv/pores/facet.hpp"
#include "pfv/pores/lanes.hpp"
#include "pfv/pores/power_centre.hpp"
#include "pfv/problem/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <optional>

namespace pfv {
namespace {

using lanes::Vector;

/// Pores between four spheres, one to a lane.
struct PoreBlock {
  static constexpr int width = 64;
  using Lane = std::array<double, width>;

  std::array<Lane, 4> x, y, z, radius; // m
  Lane centre_x, centre_y, centre_z;   // m
  Lane span;                           // of the unit edges from the first sphere
};

/// Cramer's rule on the three radical planes with the first sphere.
PFV_VECTORISED void find_centres(PoreBlock& block) {
#pragma GCC ivdep
  for (int t = 0; t < PoreBlock::width; ++t) {
    const Vector o{block.x[0][t], block.y[0][t], block.z[0][t]};
    const Vector a = Vector{block.x[1][t], block.y[1][t], block.z[1][t]} - o;
    const Vector b = Vector{block.x[2][t], block.y[2][t], block.z[2][t]} - o;
    const Vector c = Vector{block.x[3][t], block.y[3][t], block.z[3][t]} - o;
    const double r = block.radius[0][t];
    const double aa = dot(a, a), bb = dot(b, b), cc = dot(c, c);
    const double da = 0.5 * (aa + (r - block.radius[1][t]) * (r + block.radius[1][t]));
    const double db = 0.5 * (bb + (r - block.radius[2][t]) * (r + block.radius[2][t]));
    const double dc = 0.5 * (cc + (r - block.radius[3][t]) * (r + block.radius[3][t]));
    const Vector bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    const double det = dot(a, bc);
    const double scale = 1 / (det == 0 ? 1 : det);
    block.span[t] = std::abs(det) / std::sqrt(aa * bb * cc);
    const Vector centre = o + scale * (da * bc + db * ca + dc * ab);
    block.centre_x[t] = centre.x;
    block.centre_y[t] = centre.y;
    block.centre_z[t] = centre.z;
  }
}

bool at_wall(const std::array<Vertex, 4>& vertices) {
  return std::ranges::any_of(vertices, is_wall);
}

/// A flat pore and how far its neighbours let its centre go along its normal.
struct FlatPore {
  int pore;
  Vec3 point, normal;
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
};

void set_plain_centres(PoreNetwork& network, std::vector<FlatPore>& flat) {
  auto& pores = network.pores;
  const auto& spheres = network.sites.spheres;
  PoreBlock block{};
  for (std::size_t first = 0; first < pores.size(); first += PoreBlock::width) {
    const int count = static_cast<int>(std::min<std::size_t>(PoreBlock::width, pores.size() - first));
    for (int t = 0; t < count; ++t)
      for (int c = 0; c < 4; ++c) {
        const Vertex v = pores.vertices[first + t][c];
        const Sphere& sphere = spheres[is_wall(v) ? 0 : v];
        block.x[c][t] = sphere.centre.x();
        block.y[c][t] = sphere.centre.y();
        block.z[c][t] = sphere.centre.z();
        block.radius[c][t] = sphere.radius;
      }
    find_centres(block);
    for (int t = 0; t < count; ++t) {
      const std::size_t i = first + t;
      pores.centre[i] = {block.centre_x[t], block.centre_y[t], block.centre_z[t]};
      if (!at_wall(pores.vertices[i]) && block.span[t] >= PowerCentre::flat_below)
        continue;
      const auto centre = power_centre(network.walls, spheres, pores.vertices[i]);
      pores.centre[i] = centre.point;
      if (centre.flat())
        flat.push_back({static_cast<int>(i), centre.point, centre.normal});
      if (!centre.point.allFinite())
        throw SolveError(fmt::format("pore {} is flat: its centre is not finite", i));
    }
  }
}

/// Narrows where the centre of a flat pore may be by one neighbour that is not flat itself.
void narrow(FlatPore& flat, const Vec3& outward, const Vec3& neighbour) {
  const double height = (neighbour - flat.point).dot(flat.normal);
  if (outward.dot(flat.normal) > 0)
    flat.highest = std::min(flat.highest, height);
  else
    flat.lowest = std::max(flat.lowest, height);
}

void settle(PoreNetwork& network, std::vector<FlatPore>& flat) {
  const auto find = [&](int pore) -> FlatPore* {
    const auto found = std::ranges::lower_bound(flat, pore, {}, &FlatPore::pore);
    return found != flat.end() && found->pore == pore ? &*found : nullptr;
  };
  const auto& throats = network.throats;
  for (std::size_t t = 0; t < throats.size(); ++t) {
    const auto [i, j] = throats.pores[t];
    FlatPore *behind = find(i), *ahead = find(j);
    if ((behind != nullptr) == (ahead != nullptr))
      continue;
    const Vec3 normal = make_facet(network.walls, network.sites.spheres, network.corners(t)).normal;
    const Vec3 shift = network.centre_ahead(t) - network.pores.centre[j];
    if (behind)
      narrow(*behind, normal, network.pores.centre[j] + shift);
    else
      narrow(*ahead, -normal, network.pores.centre[i] - shift);
  }
  for (const FlatPore& pore : flat) {
    const double height = std::abs(pore.highest) <= std::abs(pore.lowest) ? pore.highest : pore.lowest;
    if (std::isfinite(height))
      network.pores.centre[pore.pore] = pore.point + height * pore.normal;
  }
}

} // namespace

void set_pore_centres(PoreNetwork& network) {
  std::vector<FlatPore> flat;
  set_plain_centres(network, flat);
  network.flat_pores = flat.size();
  if (!flat.empty())
    settle(network, flat);
}

} // namespace pfv
