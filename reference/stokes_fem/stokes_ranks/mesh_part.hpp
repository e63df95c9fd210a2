#pragma once

#include "reference/stokes_fem/stokes_ranks/numbering.hpp"

#include <deal.II/distributed/fully_distributed_tria.h>

namespace reference::stokes_fem {

/// What a rank keeps of the mesh: its own cells and those that touch them.
struct MeshPart {
  /// Numbers of a cell's unknowns; negative where there is none.
  struct Unknowns {
    std::array<std::array<int, 10>, 3> velocity;
    std::array<int, 4> pressure;
  };

  explicit MeshPart(MPI_Comm ranks) : mesh(ranks) {}

  dealii::parallel::fullydistributed::Triangulation<3> mesh;
  std::unique_ptr<CurvedMapping> mapping;
  std::vector<Unknowns> unknowns; // of the cells it owns, in the order of the mesh
};

/// Gives each cell of a mesh that every rank holds whole the rank that owns it.
void share_cells(Discretisation& discretisation, int ranks);

/// The part of this rank.
std::unique_ptr<MeshPart> part_of(const Discretisation& discretisation, const Numbering& numbering, MPI_Comm ranks);

} // namespace reference::stokes_fem
