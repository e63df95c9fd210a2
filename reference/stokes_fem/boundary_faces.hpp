#pragma once

// Included only by the sources of this folder that speak deal.II.

#include "reference/stokes_fem/discretisation.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

namespace reference::stokes_fem {

/// Calls visit(cell, number of the face in the cell, index of its label) for every triangle of the boundary.
template <class Visit>
void for_each_boundary_face(const Discretisation& space, const Visit& visit) {
  for (const auto& cell : space.mesh.active_cell_iterators())
    for (const unsigned face : cell->face_indices())
      if (cell->at_boundary(face))
        visit(cell, face, space.label_index.at(cell->face(face)->boundary_id()));
}

/// The six velocity nodes of a face.
inline Dofs face_nodes(const Discretisation& space, const Cell& cell, unsigned face) {
  Dofs nodes(6);
  cell_of(space.velocity, cell)->face(face)->get_dof_indices(nodes);
  for (auto& node : nodes)
    node = space.velocity_node[node];
  return nodes;
}

/// Integrates over curved boundary triangles.
inline dealii::FEFaceValues<3> face_values(const Discretisation& space, const dealii::FiniteElement<3>& element,
                                           dealii::UpdateFlags flags) {
  return {*space.mapping, element, dealii::QGaussSimplex<2>(3), flags};
}

inline const auto value_flags = dealii::update_values | dealii::update_JxW_values;

} // namespace reference::stokes_fem
