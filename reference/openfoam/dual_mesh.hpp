#pragma once

#include "reference/openfoam/foam_mesh.hpp"

namespace reference::openfoam {

/// The dual of a mesh of tetrahedra: one polyhedron for each point, one face for each edge, through the centres of the
/// tetrahedra around it. On the boundary a polyhedron ends on the polygon through the centres of the triangles around
/// its point, one for each patch that the point is on. Why: a fifth of the cells with twice as many neighbours each, to
/// which the lines between centres are nearly normal. Throws pfv::SolveError where the boundary is no surface.
FoamMesh dual_mesh(const FoamMesh& tetrahedra);

} // namespace reference::openfoam
