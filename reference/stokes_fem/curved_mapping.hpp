#pragma once

// Included only by the sources of this folder that speak deal.II.

#include "reference/stokes_fem/exact_surface.hpp"

#include <deal.II/fe/mapping_fe.h>
#include <deal.II/grid/tria.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

namespace reference::stokes_fem {

/// Where the middles of edges lie that do not lie half-way, and which cells have such an edge.
struct CurvedEdges {
  std::unordered_map<std::uint64_t, dealii::Point<3>> middle; // by edge_key
  std::vector<bool> cell_is_curved;                           // by active cell index
  std::size_t curved_cells = 0;
  std::size_t straightened_cells = 0; // cells made straight again because bending had folded them
};

/// The surface behind a boundary id of the mesh.
using SurfaceById = std::function<ExactSurface(unsigned)>;

/// Puts the middle of every boundary edge on the exact surfaces its faces stand for (their curve of intersection, when
/// two meet there), then straightens the edges of cells whose Jacobian falls below a tenth of the straight one's, and
/// with each edge those between vertices of the same numbers (`vertex_number`), as images in a periodic box are.
CurvedEdges curve_edges(const dealii::Triangulation<3>& mesh, const SurfaceById& surface,
                        const std::vector<unsigned>& vertex_number);

/// What of the curved edges is in a part of the mesh: `vertex` gives the whole mesh's number of each of the part's
/// vertices, `cell` that of each of its active cells.
CurvedEdges edges_in_part(const CurvedEdges& edges, const dealii::Triangulation<3>& part,
                          const std::vector<unsigned>& vertex, const std::vector<std::size_t>& cell);

/// Quadratic map of each tetrahedron from its four vertices and six edge middles.
class CurvedMapping : public dealii::MappingFE<3> {
public:
  explicit CurvedMapping(std::shared_ptr<const CurvedEdges> edges);

  std::unique_ptr<dealii::Mapping<3>> clone() const override;
  bool is_curved(const dealii::Triangulation<3>::cell_iterator& cell) const;
  /// The four vertices and six edge middles of a cell.
  std::vector<dealii::Point<3>> points(const dealii::Triangulation<3>::cell_iterator& cell) const;
  const CurvedEdges& edges() const { return *edges_; }

protected:
  std::vector<dealii::Point<3>>
  compute_mapping_support_points(const dealii::Triangulation<3>::cell_iterator& cell) const override;

private:
  std::shared_ptr<const CurvedEdges> edges_;
};

} // namespace reference::stokes_fem
