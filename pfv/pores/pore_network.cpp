#include "pfv/pores/pore_network.hpp"

#include "pfv/pores/ball_part.hpp"
#include "pfv/pores/facet.hpp"
#include "pfv/pores/power_centre.hpp"
#include "pfv/pores/triangulate.hpp"
#include "pfv/problem/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace pfv {
namespace {

/// Vertices of the facet opposite each vertex of a positively oriented cell, so that its normal points out of the cell.
constexpr int facet_vertices[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

/// The pyramid between a facet and the centre of one of its pores, positive when the centre is on the pore's side.
struct Pyramid {
  double volume = 0;
  std::array<BallPart, 3> balls{}; // by corner of the facet
};

class Builder {
public:
  Builder(const Packing& packing, Triangulation cells) : packing_(packing), cells_(std::move(cells)) {
    network_.box = packing.box;
    network_.hidden_spheres = cells_.hidden_spheres;
    cuts_.reserve(packing.spheres.size());
    for (const auto& sphere : packing.spheres)
      cuts_.push_back(wall_cuts(sphere, packing.box));
  }

  PoreNetwork build() {
    add_pores();
    for (int i = 0; i < static_cast<int>(cells_.cells.size()); ++i)
      for (int f = 0; f < 4; ++f)
        if (cells_.neighbours[i][f] > i)
          add_throat(i, f);
    close_wall_pores();
    return std::move(network_);
  }

private:
  void add_pores() {
    auto& pores = network_.pores;
    const std::size_t count = cells_.cells.size();
    pores.vertices = cells_.cells;
    pores.centre.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      pores.centre[i] = power_centre(packing_, cells_.cells[i]);
      if (!pores.centre[i].allFinite())
        throw SolveError(fmt::format("pore {} is flat: its centre is not finite", i));
    }
    pores.volume.assign(count, 0);
    pores.void_volume.assign(count, 0);
    pores.wall_area.assign(count, {});
    network_.spheres.volume.assign(packing_.spheres.size(), 0);
    network_.spheres.wetted_surface.assign(packing_.spheres.size(), 0);
    outward_.assign(count, Vec3::Zero());
  }

  Pyramid pyramid(const Facet& facet, const Vec3& apex, double side) const {
    Pyramid result;
    result.volume = side * facet.area * (apex - facet.point).dot(facet.normal) / 3;
    for (int c = 0; c < 3; ++c) {
      const auto& [vertex, next, previous] = facet.corners[c];
      if (is_wall(vertex))
        continue;
      const Sphere& sphere = packing_.spheres[vertex];
      const auto part = ball_in_cone(sphere.radius, cuts_[vertex], next, previous, apex - sphere.centre);
      result.balls[c] = {side * part.volume, side * part.surface};
    }
    return result;
  }

  void add_throat(int i, int f) {
    const int j = cells_.neighbours[i][f];
    std::array<Vertex, 3> vertices;
    for (int c = 0; c < 3; ++c)
      vertices[c] = cells_.cells[i][facet_vertices[f][c]];
    const Facet facet = make_facet(packing_, vertices);
    const Pyramid behind = pyramid(facet, network_.pores.centre[i], -1);
    const Pyramid ahead = pyramid(facet, network_.pores.centre[j], 1);

    auto& throats = network_.throats;
    double solid_volume = 0, solid_area = 0;
    std::array<double, 3> wetted{}, sector{};
    for (int c = 0; c < 3; ++c) {
      const auto& [vertex, next, previous] = facet.corners[c];
      if (is_wall(vertex))
        continue;
      wetted[c] = behind.balls[c].surface + ahead.balls[c].surface;
      sector[c] = disc_in_wedge(packing_.spheres[vertex].radius, cuts_[vertex], next, previous);
      solid_area += sector[c];
      const double ball = behind.balls[c].volume + ahead.balls[c].volume;
      solid_volume += ball;
      network_.spheres.volume[vertex] += ball;
      network_.spheres.wetted_surface[vertex] += wetted[c];
    }
    throats.pores.push_back({i, j});
    throats.vertices.push_back(vertices);
    throats.normal.push_back(facet.normal);
    throats.area.push_back(facet.area);
    throats.fluid_area.push_back(facet.area - solid_area);
    throats.length.push_back((network_.pores.centre[j] - network_.pores.centre[i]).dot(facet.normal));
    throats.void_volume.push_back(behind.volume + ahead.volume - solid_volume);
    throats.wetted_surface.push_back(wetted);
    throats.sector_area.push_back(sector);
    add_to_pore(i, behind);
    add_to_pore(j, ahead);
    outward_[i] += facet.area * facet.normal;
    outward_[j] -= facet.area * facet.normal;
  }

  void add_to_pore(int pore, const Pyramid& part) {
    network_.pores.volume[pore] += part.volume;
    network_.pores.void_volume[pore] +=
        part.volume - part.balls[0].volume - part.balls[1].volume - part.balls[2].volume;
  }

  /// A closed surface has no net area vector, so what a pore's facets leave open lies on its walls.
  void close_wall_pores() {
    for (std::size_t i = 0; i < network_.pores.size(); ++i)
      for (const Vertex vertex : cells_.cells[i])
        if (is_wall(vertex))
          network_.pores.wall_area[i][index(face_of(vertex))] = -outward_[i].dot(outward_normal(face_of(vertex)));
  }

  const Packing& packing_;
  Triangulation cells_;
  std::vector<std::vector<WallCut>> cuts_;
  std::vector<Vec3> outward_; // m^2, sum of the area vectors of each pore's facets
  PoreNetwork network_;
};

} // namespace

bool PoreNetwork::Pores::touches(std::size_t pore, Face face) const {
  return std::ranges::find(vertices[pore], wall_vertex(face)) != vertices[pore].end();
}

double PoreNetwork::porosity() const {
  return std::accumulate(pores.void_volume.begin(), pores.void_volume.end(), 0.0) / box.volume();
}

PoreNetwork build_pore_network(const Packing& packing, Clock& clock) {
  Triangulation cells;
  {
    const auto timing = clock.stage("triangulate");
    cells = triangulate(packing);
  }
  const auto timing = clock.stage("geometry");
  return Builder(packing, std::move(cells)).build();
}

} // namespace pfv
