#include "reference/stokes_fem/stokes_ranks/mesh_part.hpp"

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>

namespace reference::stokes_fem {

namespace {

std::unique_ptr<CurvedMapping> mapping_of(const dealii::Triangulation<3>& part, const Discretisation& space,
                                          const std::vector<std::size_t>& whole_cell,
                                          const std::vector<Cell>& whole_cells) {
  std::vector<unsigned> vertex(part.n_vertices());
  for (const auto& cell : part.active_cell_iterators())
    for (unsigned v = 0; v < 4; ++v)
      vertex[cell->vertex_index(v)] = whole_cells[whole_cell[cell->active_cell_index()]]->vertex_index(v);
  return std::make_unique<CurvedMapping>(
      std::make_shared<CurvedEdges>(edges_in_part(space.mapping->edges(), part, vertex, whole_cell)));
}

MeshPart::Unknowns unknowns_of(const Cell& cell, const Discretisation& space, const Numbering& numbering) {
  Dofs velocity(10);
  Dofs pressure(4);
  velocity_nodes(space, cell, velocity);
  pressure_nodes(space, cell, pressure);
  MeshPart::Unknowns unknowns;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < 10; ++i)
      unknowns.velocity[c][i] = numbering.velocity[c][velocity[i]];
  for (std::size_t k = 0; k < 4; ++k)
    unknowns.pressure[k] = numbering.pressure[pressure[k]];
  return unknowns;
}

} // namespace

void share_cells(Discretisation& space, int ranks) {
  dealii::GridTools::partition_triangulation(static_cast<unsigned>(ranks), space.mesh,
                                             dealii::SparsityTools::Partitioner::metis);
}

std::unique_ptr<MeshPart> part_of(const Discretisation& space, const Numbering& numbering, MPI_Comm ranks) {
  auto part = std::make_unique<MeshPart>(ranks);
  part->mesh.create_triangulation(
      dealii::TriangulationDescription::Utilities::create_description_from_triangulation(space.mesh, ranks));
  std::vector<Cell> whole_cells;
  for (const auto& cell : space.mesh.active_cell_iterators())
    whole_cells.push_back(cell);
  std::vector<std::size_t> whole_cell;
  for (const auto& cell : part->mesh.active_cell_iterators()) {
    whole_cell.push_back(cell->id().get_coarse_cell_id());
    if (cell->is_locally_owned())
      part->unknowns.push_back(unknowns_of(whole_cells[whole_cell.back()], space, numbering));
  }
  part->mapping = mapping_of(part->mesh, space, whole_cell, whole_cells);
  return part;
}

} // namespace reference::stokes_fem
