#include "reference/stokes_fem/stokes_system.hpp"

#include "reference/stokes_fem/cell_integrals.hpp"
#include "reference/stokes_fem/edge_ends.hpp"

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>

namespace reference::stokes_fem {

namespace {

// Column-major storage of the transposed pattern: outer index = row of the pattern.
template <class Matrix>
Matrix zero_matrix(const dealii::DynamicSparsityPattern& pattern, Eigen::Index rows, Eigen::Index columns) {
  Matrix matrix(rows, columns);
  matrix.resizeNonZeros(static_cast<Eigen::Index>(pattern.n_nonzero_elements()));
  int entry = 0;
  for (unsigned outer = 0; outer < pattern.n_rows(); ++outer) {
    matrix.outerIndexPtr()[outer] = entry;
    for (auto it = pattern.begin(outer); it != pattern.end(outer); ++it)
      matrix.innerIndexPtr()[entry++] = static_cast<int>(it->column());
  }
  matrix.outerIndexPtr()[pattern.n_rows()] = entry;
  std::fill_n(matrix.valuePtr(), entry, 0.0);
  return matrix;
}

StokesSystem empty_system(const Discretisation& space) {
  const auto nodes = space.velocity_nodes;
  const auto pressures = space.pressure_nodes;
  dealii::DynamicSparsityPattern lower(nodes, nodes);
  dealii::DynamicSparsityPattern coupling(pressures, nodes);
  Dofs velocity(10);
  Dofs pressure(4);
  for (const auto& cell : space.mesh.active_cell_iterators()) {
    velocity_nodes(space, cell, velocity);
    pressure_nodes(space, cell, pressure);
    std::ranges::sort(velocity);
    for (std::size_t column = 0; column < velocity.size(); ++column)
      lower.add_entries(velocity[column], velocity.begin() + static_cast<std::ptrdiff_t>(column), velocity.end(), true);
    for (const auto row : pressure)
      coupling.add_entries(row, velocity.begin(), velocity.end(), true);
  }
  const auto n = static_cast<Eigen::Index>(nodes);
  const auto m = static_cast<Eigen::Index>(pressures);
  const auto divergence = zero_matrix<SparseRows>(coupling, m, n);
  return {zero_matrix<SparseMatrix>(lower, n, n),
          {divergence, divergence, divergence},
          Eigen::VectorXd::Zero(n),
          Eigen::VectorXd::Zero(m),
          {}};
}

void add_cell(const CellIntegrals& cell, const Dofs& nodes, const Dofs& pressures, StokesSystem& system) {
  for (int i = 0; i < 10; ++i)
    system.node_volume[static_cast<Eigen::Index>(nodes[i])] += cell.velocity_volume[i];
  for (int k = 0; k < 4; ++k)
    system.pressure_volume[static_cast<Eigen::Index>(pressures[k])] += cell.pressure_volume[k];
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j)
      if (nodes[i] >= nodes[j])
        system.laplacian.coeffRef(static_cast<int>(nodes[i]), static_cast<int>(nodes[j])) += cell.stiffness(i, j);
  for (std::size_t c = 0; c < 3; ++c)
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 10; ++i)
        system.divergence[c].coeffRef(static_cast<int>(pressures[k]), static_cast<int>(nodes[i])) +=
            cell.coupling[c](k, i);
}

} // namespace

StokesSystem assemble(const Discretisation& space) {
  StokesSystem system = empty_system(space);
  CellIntegrator integrate(*space.mapping);
  Dofs nodes(10);
  Dofs pressures(4);
  for (const auto& cell : space.mesh.active_cell_iterators()) {
    velocity_nodes(space, cell, nodes);
    pressure_nodes(space, cell, pressures);
    add_cell(integrate(cell), nodes, pressures, system);
  }
  system.ends = edge_ends(space);
  return system;
}

} // namespace reference::stokes_fem
