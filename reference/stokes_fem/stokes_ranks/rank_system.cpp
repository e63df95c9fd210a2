#include "reference/stokes_fem/stokes_ranks/rank_system.hpp"

#include "reference/stokes_fem/cell_integrals.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>

namespace reference::stokes_fem {

namespace {

using dealii::IndexSet;
using Unknowns = MeshPart::Unknowns;

IndexSet owned(const std::vector<int>& first, MPI_Comm ranks) {
  const auto rank = static_cast<std::size_t>(dealii::Utilities::MPI::this_mpi_process(ranks));
  IndexSet range(static_cast<unsigned>(first.back()));
  range.add_range(static_cast<unsigned>(first[rank]), static_cast<unsigned>(first[rank + 1]));
  return range;
}

template <std::size_t N>
Dofs present(const std::array<int, N>& numbers) {
  Dofs list;
  for (const int number : numbers)
    if (number >= 0)
      list.push_back(static_cast<unsigned>(number));
  std::ranges::sort(list);
  return list;
}

// Rows of this rank and, until they are sent to their own, rows of others that its cells touch.
IndexSet touched_rows(const MeshPart& part, IndexSet rows) {
  Dofs all;
  for (const Unknowns& cell : part.unknowns)
    for (const auto& component : cell.velocity)
      for (const int number : component)
        if (number >= 0 && !rows.is_element(static_cast<unsigned>(number)))
          all.push_back(static_cast<unsigned>(number));
  std::ranges::sort(all);
  rows.add_indices(all.begin(), std::unique(all.begin(), all.end()));
  return rows;
}

template <class ColumnsOf>
void shape(const MeshPart& part, const IndexSet& rows, const IndexSet& columns, const IndexSet& touched, MPI_Comm ranks,
           const ColumnsOf& columns_of, dealii::PETScWrappers::MPI::SparseMatrix& matrix) {
  dealii::DynamicSparsityPattern pattern(rows.size(), columns.size(), touched);
  for (const Unknowns& cell : part.unknowns)
    for (std::size_t c = 0; c < 3; ++c) {
      const Dofs entries = columns_of(cell, c);
      for (const auto row : present(cell.velocity[c]))
        pattern.add_entries(row, entries.begin(), entries.end(), true);
    }
  dealii::SparsityTools::distribute_sparsity_pattern(pattern, rows, ranks, touched);
  matrix.reinit(rows, columns, pattern, ranks);
}

// Of a held unknown, whose number is negative, PETSc takes no notice.
template <class Block>
void add(const std::array<int, 10>& rows, const auto& columns, const Block& block,
         dealii::PETScWrappers::MPI::SparseMatrix& matrix) {
  const PetscErrorCode error =
      MatSetValues(matrix, static_cast<PetscInt>(rows.size()), rows.data(), static_cast<PetscInt>(columns.size()),
                   columns.data(), block.data(), ADD_VALUES);
  AssertThrow(error == 0, dealii::ExcPETScError(error));
}

} // namespace

std::unique_ptr<RankSystem> faces_system(const Boundary& boundary, const pfv::FaceConditions& faces,
                                         const Numbering& numbering, MPI_Comm ranks) {
  auto made = std::make_unique<RankSystem>();
  RankSystem& system = *made;
  const IndexSet own = owned(numbering.first_velocity, ranks);
  system.load.reinit(own, ranks);
  for (const pfv::Face face : pfv::all_faces) {
    const auto f = static_cast<std::size_t>(index(face));
    const Eigen::VectorXd& weight = boundary.face_weight[f];
    if (weight.size() == 0)
      continue;
    auto& outflow = system.outflow[f];
    outflow.reinit(own, ranks);
    const double sign = is_upper(face) ? 1 : -1;
    const auto& numbers = numbering.velocity[static_cast<std::size_t>(index(axis_of(face)))];
    for (std::size_t node = 0; node < numbers.size(); ++node)
      if (numbers[node] >= 0 && own.is_element(static_cast<unsigned>(numbers[node])))
        outflow[static_cast<unsigned>(numbers[node])] = sign * weight[static_cast<Eigen::Index>(node)];
    outflow.compress(dealii::VectorOperation::insert);
    if (const auto* pressure = std::get_if<pfv::Pressure>(&faces[f]))
      system.load.add(-pressure->value, outflow);
  }
  return made;
}

void add_cells(const MeshPart& part, const Numbering& numbering, const pfv::Vec3& mean_gradient, int without_equation,
               RankSystem& system) {
  const MPI_Comm ranks = part.mesh.get_communicator();
  const IndexSet velocities = owned(numbering.first_velocity, ranks);
  const IndexSet touched = touched_rows(part, velocities);
  shape(
      part, velocities, velocities, touched, ranks,
      [](const Unknowns& cell, std::size_t c) { return present(cell.velocity[c]); }, system.laplacian);
  shape(
      part, velocities, owned(numbering.first_pressure, ranks), touched, ranks,
      [](const Unknowns& cell, std::size_t) { return present(cell.pressure); }, system.gradient);
  CellIntegrator integrate(*part.mapping);
  auto unknowns = part.unknowns.begin();
  for (const auto& cell : part.mesh.active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    const CellIntegrals& integrals = integrate(cell);
    auto pressures = unknowns->pressure;
    std::ranges::replace(pressures, without_equation, -1);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto& rows = unknowns->velocity[c];
      add(rows, rows, integrals.stiffness, system.laplacian);
      // PETSc wants row after row, and a block of 4 rows of 10 stored by columns is the transpose of that.
      add(rows, pressures, integrals.coupling[c], system.gradient);
      for (std::size_t i = 0; i < 10; ++i)
        if (rows[i] >= 0 && mean_gradient[static_cast<int>(c)] != 0)
          system.load(static_cast<unsigned>(rows[i])) -=
              mean_gradient[static_cast<int>(c)] * integrals.velocity_volume[static_cast<int>(i)];
    }
    ++unknowns;
  }
  system.laplacian.compress(dealii::VectorOperation::add);
  system.gradient.compress(dealii::VectorOperation::add);
  system.load.compress(dealii::VectorOperation::add);
}

} // namespace reference::stokes_fem
