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
constexpr double no_opening = 1e-14;     // likewise: what round-off leaves of sectors as large as the sphere's section
constexpr double inverted_below = -1e-6; // l of the largest side of the box; walls are only that exact

class Measuring {
public:
  explicit Measuring(PoreNetwork& network) : network_(network) {
    std::ranges::fill(network.pores.volume, 0);
    std::ranges::fill(network.pores.void_volume, 0);
    std::ranges::fill(network.spheres.volume, 0);
    std::ranges::fill(network.spheres.wetted_surface, 0);
    network.closed_throats = network.inverted_throats = 0;
  }

  void interior_throats() {
    FacetBlock facets{};
    BipyramidBlock bipyramids{};
    for (std::size_t first = 0; first < network_.throats.interior; first += FacetBlock::width) {
      const int count = gather(network_, first, facets);
      for (int t = 0; t < count; ++t)
        gather_centres(first + t, t, bipyramids);
      facets.measure();
      bipyramids.measure(facets);
      for (int t = 0; t < count; ++t) {
        if (facets.is_crowded(t))
          one_by_one(first + t);
        else
          store(first + t, measures(facets, bipyramids, t));
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
    for (std::size_t t = network_.throats.interior; t < network_.throats.size(); ++t) {
      one_by_one(t);
      if (!network_.throats.gap.empty())
        openings_one_by_one(t);
    }
  }

  /// A closed surface has no net area vector, so what a pore's facets leave open lies on its walls.
  void wall_parts() {
    for (auto& part : network_.wall_parts) {
      const auto& cell = network_.pores.vertices[part.pore];
      const Vec3 outward = outward_normal(part.face);
      part.area = 0;
      for (int f = 0; f < 4; ++f) {
        const auto vertices = facet_opposite(cell, f);
        if (std::ranges::all_of(vertices, is_wall))
          continue;
        const Facet facet = make_facet(network_.walls, network_.sites.spheres, vertices);
        part.area -= facet.area * facet.normal.dot(outward);
      }
    }
  }

private:
  void gather_centres(std::size_t throat, int lane, BipyramidBlock& block) const {
    const Vec3& behind = network_.pores.centre[network_.throats.pores[throat][0]];
    const Vec3 ahead = network_.centre_ahead(throat);
    block.behind.x[lane] = behind.x();
    block.behind.y[lane] = behind.y();
    block.behind.z[lane] = behind.z();
    block.ahead.x[lane] = ahead.x();
    block.ahead.y[lane] = ahead.y();
    block.ahead.z[lane] = ahead.z();
  }

  static ThroatMeasures measures(const FacetBlock& facets, const BipyramidBlock& block, int t) {
    return {.plane = {{}, facets.area[t], {facets.sector[0][t], facets.sector[1][t], facets.sector[2][t]}},
            .length = block.length[t],
            .behind = {block.behind.volume[t], block.behind.void_volume[t]},
            .ahead = {block.ahead.volume[t], block.ahead.void_volume[t]},
            .wetted = {block.wetted[0][t], block.wetted[1][t], block.wetted[2][t]},
            .ball = {block.ball[0][t], block.ball[1][t], block.ball[2][t]}};
  }

  void one_by_one(std::size_t t) {
    store(t, measure_throat(network_.walls, network_.sites.spheres, network_.corners(t),
                            network_.pores.centre[network_.throats.pores[t][0]], network_.centre_ahead(t)));
  }

  void openings_one_by_one(std::size_t t) {
    const auto& spheres = network_.sites.spheres;
    const auto corners = network_.corners(t);
    network_.throats.gap[t] = smallest_gap(network_.walls, spheres, corners);
    const Vertex sphere = *std::ranges::find_if_not(corners, is_wall);
    network_.throats.contrast[t] =
        pore_contrast(spheres[sphere], network_.pores.centre[network_.throats.pores[t][0]], network_.centre_ahead(t));
  }

  void store(std::size_t t, const ThroatMeasures& measures) {
    auto& throats = network_.throats;
    throats.fluid_area[t] = measures.plane.fluid_area();
    throats.length[t] = measures.length;
    throats.void_volume[t] = measures.behind.void_volume + measures.ahead.void_volume;
    throats.wetted_surface[t] = measures.wetted;
    if (!throats.area.empty())
      throats.area[t] = measures.plane.area;
    const auto corners = network_.corners(t);
    for (const Vertex v : corners)
      if (!is_wall(v) && throats.fluid_area[t] < no_opening * std::pow(network_.sites.spheres[v].radius, 2))
        throats.fluid_area[t] = 0;
    bool closed = throats.fluid_area[t] == 0;
    for (int c = 0; c < 3; ++c)
      if (const Vertex v = corners[c]; !is_wall(v)) {
        const double radius = network_.sites.spheres[v].radius;
        closed = closed && measures.plane.area > no_facet * radius * radius;
        const int k = network_.sites.number[v];
        network_.spheres.volume[k] += measures.ball[c];
        network_.spheres.wetted_surface[k] += measures.wetted[c];
      }
    const auto [i, j] = throats.pores[t];
    network_.pores.volume[i] += measures.behind.volume;
    network_.pores.volume[j] += measures.ahead.volume;
    network_.pores.void_volume[i] += measures.behind.void_volume;
    network_.pores.void_volume[j] += measures.ahead.void_volume;
    network_.closed_throats += closed;
    if (measures.length < inverted_below * network_.box.size().maxCoeff())
      ++network_.inverted_throats;
  }

  PoreNetwork& network_;
};

} // namespace

void measure(PoreNetwork& network) {
  Measuring measuring(network);
  measuring.interior_throats();
  measuring.wall_throats();
  measuring.wall_parts();
}

} // namespace pfv
