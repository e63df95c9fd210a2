#pragma once

#include "meshing/linear_mesh.hpp"

namespace meshing {

/// The mesh without the tetrahedra that have two faces on one sphere or bridge. Where two triangles meet on the wrong
/// diagonal of their four corners, the solid, which should be convex, has a dent; such a tetrahedron fills it. It is
/// nearly flat, bent elements on it overlap themselves, and its other two faces, the right diagonal, are as good a
/// boundary: they take the place of the first two. One that would leave an edge with more than two boundary triangles
/// stays. Nodes that are no longer used are dropped.
LinearMesh without_dented_cells(LinearMesh mesh);

} // namespace meshing
