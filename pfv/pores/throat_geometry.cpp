#include "pfv/pores/throat_geometry.hpp"

#include "pfv/pores/bipyramid_block.hpp"
#include "pfv/pores/facet.hpp"
#include "pfv/pores/power_centre.hpp"
#include "pfv/pores/throat_planes.hpp"

#include <algorithm>
#include <cmath>

namespace pfv {
namespace {

constexpr double no_facet = 1e-9;        // of a sphere's squared radius: one between spheres centred on a wall
constexpr double inverted_below = -1e-6; // l of the largest side of the box; walls are only that exact

class Measuring {
public:
  explicit Measuring(PoreNetwork& network)
      : network_(network), inverted_(inverted_below * network.box.size().maxCoeff()) {
    std::ranges::fill(network.pores.volume, 0);
    std::ranges::fill(network.pores.void_volume, 0);
    std::ranges::fill(network.spheres.of_sites, std::array{0.0, 0.0});
    network.closed_throats = network.inverted_throats = 0;
  }

  void interior_throats() {
    FacetBlock facets{};
    BipyramidBlock bipyramids{};
    for (std::size_t first = 0; first < network_.throats.interior; first += FacetBlock::width) {
      const int count = gather(network_, first, facets);
      gather_centres(first, count, bipyramids);
      facets.measure();
      bipyramids.measure(facets);
      for (int t = 0; t < count; ++t) {
        if (facets.is_crowded(t))
          one_by_one(first + t);
        else
          store(first + t, facets.vertices[t], measures(facets, bipyramids, t));
      }
      if (!network_.throats.gap.empty()) {
        facets.measure_gaps();
        bipyramids.measure_contrasts(facets);
        const auto place = static_cast<std::ptrdiff_t>(first);
        std::copy_n(facets.gap.begin(), count, network_.throats.gap.begin() + place);
        std::copy_n(bipyramids.contrast.begin(), count, network_.throats.contrast.begin() + place);
      }
    }
  }

  void wall_throats() {
    WallThroatBlock block{};
    for (std::size_t first = network_.throats.interior; first < network_.throats.size(); first += block.width) {
      const int count = gather(network_, first, block);
      gather_centres(first, count, block);
      block.measure_facets();
      block.measure_bipyramids();
      for (int t = 0; t < count; ++t) {
        if (block.is_crowded(t))
          one_by_one(first + t);
        else
          store(first + t, block.vertices[t], measures(block, t));
        if (!network_.throats.gap.empty())
          openings_one_by_one(first + t);
      }
    }
  }

  /// A closed surface has no net area vector, so what a pore's facets leave open lies on its walls. Those through a
  /// wall stand upright on it: what lies on it is below the one that is not.
  void wall_parts() {
    for (auto& part : network_.wall_parts) {
      const auto& cell = network_.pores.vertices[part.pore];
      const Vec3 outward = outward_normal(part.face);
      const auto f = std::ranges::find(cell, wall_vertex(part.face)) - cell.begin();
      const auto vertices = facet_opposite(cell, static_cast<int>(f));
      part.area = 0;
      if (std::ranges::all_of(vertices, is_wall))
        continue;
      const Facet facet = make_facet(network_.walls, network_.sites.spheres, vertices);
      part.area = -facet.area * facet.normal.dot(outward);
    }
  }

  void spheres() {
    auto& spheres = network_.spheres;
    std::ranges::fill(spheres.volume, 0);
    std::ranges::fill(spheres.wetted_surface, 0);
    for (std::size_t s = 0; s < spheres.of_sites.size(); ++s) {
      const int k = network_.sites.number[s];
      spheres.volume[k] += spheres.of_sites[s][0];
      spheres.wetted_surface[k] += spheres.of_sites[s][1];
    }
  }

private:
  /// Of the pores behind and ahead of throats.
  template <typename Block>
  void gather_centres(std::size_t first, int count, Block& block) const {
    for (int t = 0; t < count; ++t) {
      const Vec3& behind = network_.pores.centre[network_.throats.pores[first + t][0]];
      const Vec3 ahead = network_.centre_ahead(first + t);
      block.behind.x[t] = behind.x();
      block.behind.y[t] = behind.y();
      block.behind.z[t] = behind.z();
      block.ahead.x[t] = ahead.x();
      block.ahead.y[t] = ahead.y();
      block.ahead.z[t] = ahead.z();
    }
  }

  static ThroatMeasures measures(const FacetBlock& facets, const BipyramidBlock& block, int t) {
    return {.plane = plane(facets, t),
            .length = block.length[t],
            .behind = {block.behind.volume[t], block.behind.void_volume[t]},
            .ahead = {block.ahead.volume[t], block.ahead.void_volume[t]},
            .wetted = {block.wetted[0][t], block.wetted[1][t], block.wetted[2][t]},
            .ball = {block.ball[0][t], block.ball[1][t], block.ball[2][t]}};
  }

  static ThroatMeasures measures(const WallThroatBlock& block, int t) {
    return {.plane = plane(block, t),
            .length = block.length[t],
            .behind = {block.behind.volume[t], block.behind.void_volume[t]},
            .ahead = {block.ahead.volume[t], block.ahead.void_volume[t]},
            .wetted = block.by_vertex({block.wetted[0][t], block.wetted[1][t], block.wetted[2][t]}, t),
            .ball = block.by_vertex({block.ball[0][t], block.ball[1][t], 0}, t)};
  }

  void one_by_one(std::size_t t) {
    const auto corners = network_.corners(t);
    store(t, corners,
          measure_throat(network_.walls, network_.sites.spheres, corners,
                         network_.pores.centre[network_.throats.pores[t][0]], network_.centre_ahead(t)));
  }

  bool is_facet(double area, const std::array<Vertex, 3>& corners) const {
    return std::ranges::all_of(corners, [&](Vertex v) {
      return is_wall(v) || area > no_facet * std::pow(network_.sites.spheres[v].radius, 2);
    });
  }

  void openings_one_by_one(std::size_t t) {
    const auto& spheres = network_.sites.spheres;
    const auto corners = network_.corners(t);
    network_.throats.gap[t] = smallest_gap(network_.walls, spheres, corners);
    const Vertex sphere = *std::ranges::find_if_not(corners, is_wall);
    network_.throats.contrast[t] =
        pore_contrast(spheres[sphere], network_.pores.centre[network_.throats.pores[t][0]], network_.centre_ahead(t));
  }

  void store(std::size_t t, const std::array<Vertex, 3>& corners, const ThroatMeasures& measures) {
    auto& throats = network_.throats;
    throats.fluid_area[t] = measures.plane.fluid_area;
    throats.length[t] = measures.length;
    throats.void_volume[t] = measures.behind.void_volume + measures.ahead.void_volume;
    double wetted_by_spheres = 0;
    if (!throats.area.empty())
      throats.area[t] = measures.plane.area;
    for (int c = 0; c < 3; ++c)
      if (!is_wall(corners[c])) {
        auto& [volume, wetted_surface] = network_.spheres.of_sites[corners[c]];
        volume += measures.ball[c];
        wetted_surface += measures.wetted[c];
        wetted_by_spheres += measures.wetted[c];
      }
    throats.wetted_surface[t] = wetted_by_spheres;
    for (int c = 0; c < 3; ++c)
      throats.wetted_parts[t][c] = static_cast<float>(measures.wetted[c]);
    if (measures.plane.fluid_area == 0 && is_facet(measures.plane.area, corners))
      ++network_.closed_throats;
    const auto [i, j] = throats.pores[t];
    network_.pores.volume[i] += measures.behind.volume;
    network_.pores.volume[j] += measures.ahead.volume;
    network_.pores.void_volume[i] += measures.behind.void_volume;
    network_.pores.void_volume[j] += measures.ahead.void_volume;
    if (measures.length < inverted_)
      ++network_.inverted_throats;
  }

  PoreNetwork& network_;
  double inverted_; // m, a length below it is
};

} // namespace

void measure(PoreNetwork& network) {
  Measuring measuring(network);
  measuring.interior_throats();
  measuring.wall_throats();
  measuring.spheres();
  measuring.wall_parts();
}

} // namespace pfv
