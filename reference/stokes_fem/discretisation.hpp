#pragma once

// Included only by the sources of this folder that speak deal.II.

#include "reference/stokes_fem/curved_mapping.hpp"
#include "reference/stokes_fem/discretise.hpp"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/grid/tria.h>

#include <map>
#include <vector>

namespace reference::stokes_fem {

/// Taylor-Hood on tetrahedra. The three velocity components share one quadratic scalar space, as nothing but their
/// boundary conditions differs.
struct Discretisation {
  dealii::Triangulation<3> mesh;
  std::vector<BoundaryLabel> labels;   // the pieces of boundary
  std::map<unsigned, int> label_index; // into labels, by boundary id
  std::unique_ptr<CurvedMapping> mapping;
  dealii::FE_SimplexP<3> quadratic{2};
  dealii::FE_SimplexP<3> linear{1};
  dealii::DoFHandler<3> velocity; // one component
  dealii::DoFHandler<3> pressure;
  std::vector<unsigned> velocity_node; // by the library's number; nodes that are one in a periodic box share theirs
  std::vector<unsigned> pressure_node;
  std::size_t velocity_nodes = 0;
  std::size_t pressure_nodes = 0;
};

using Cell = dealii::Triangulation<3>::active_cell_iterator;
using Dofs = std::vector<dealii::types::global_dof_index>;

/// The same cell as one of the two spaces sees it.
inline dealii::DoFHandler<3>::active_cell_iterator cell_of(const dealii::DoFHandler<3>& space, const Cell& cell) {
  return {&space.get_triangulation(), cell->level(), cell->index(), &space};
}

/// The ten velocity nodes of a cell.
inline void velocity_nodes(const Discretisation& space, const Cell& cell, Dofs& nodes) {
  cell_of(space.velocity, cell)->get_dof_indices(nodes);
  for (auto& node : nodes)
    node = space.velocity_node[node];
}

/// Its four pressure nodes.
inline void pressure_nodes(const Discretisation& space, const Cell& cell, Dofs& nodes) {
  cell_of(space.pressure, cell)->get_dof_indices(nodes);
  for (auto& node : nodes)
    node = space.pressure_node[node];
}

} // namespace reference::stokes_fem
