#include "reference/stokes_fem/stokes_system.hpp"

#include "reference/stokes_fem/discretisation.hpp"
#include "reference/stokes_fem/edge_ends.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
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

void add_cell(const dealii::FEValues<3>& velocity, const dealii::FEValues<3>& pressure, const Dofs& nodes,
              const Dofs& pressures, StokesSystem& system) {
  Eigen::Matrix<double, 10, 10> stiffness = Eigen::Matrix<double, 10, 10>::Zero();
  std::array<Eigen::Matrix<double, 4, 10>, 3> coupling;
  coupling.fill(Eigen::Matrix<double, 4, 10>::Zero());
  for (const unsigned q : velocity.quadrature_point_indices()) {
    const double weight = velocity.JxW(q);
    Eigen::Matrix<double, 10, 3> gradients;
    for (unsigned i = 0; i < 10; ++i)
      for (unsigned c = 0; c < 3; ++c)
        gradients(i, c) = velocity.shape_grad(i, q)[c];
    stiffness += weight * gradients * gradients.transpose();
    for (unsigned k = 0; k < 4; ++k)
      for (unsigned c = 0; c < 3; ++c)
        coupling[c].row(k) += weight * pressure.shape_value(k, q) * gradients.col(c).transpose();
    for (unsigned i = 0; i < 10; ++i)
      system.node_volume[static_cast<Eigen::Index>(nodes[i])] += weight * velocity.shape_value(i, q);
    for (unsigned k = 0; k < 4; ++k)
      system.pressure_volume[static_cast<Eigen::Index>(pressures[k])] += weight * pressure.shape_value(k, q);
  }
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j)
      if (nodes[i] >= nodes[j])
        system.laplacian.coeffRef(static_cast<int>(nodes[i]), static_cast<int>(nodes[j])) += stiffness(i, j);
  for (std::size_t c = 0; c < 3; ++c)
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 10; ++i)
        system.divergence[c].coeffRef(static_cast<int>(pressures[k]), static_cast<int>(nodes[i])) += coupling[c](k, i);
}

} // namespace

StokesSystem assemble(const Discretisation& space) {
  StokesSystem system = empty_system(space);
  // On straight cells all integrands are polynomials of degree 2; on curved ones they are not polynomials at all.
  const dealii::MappingFE<3> straight_mapping(space.linear);
  const dealii::QGaussSimplex<3> few(2);
  const dealii::QGaussSimplex<3> many(3);
  const auto gradients = dealii::update_values | dealii::update_gradients | dealii::update_JxW_values;
  dealii::FEValues<3> straight(straight_mapping, space.quadratic, few, gradients);
  dealii::FEValues<3> straight_pressure(straight_mapping, space.linear, few, dealii::update_values);
  dealii::FEValues<3> curved(*space.mapping, space.quadratic, many, gradients);
  dealii::FEValues<3> curved_pressure(*space.mapping, space.linear, many, dealii::update_values);
  Dofs nodes(10);
  Dofs pressures(4);
  for (const auto& cell : space.mesh.active_cell_iterators()) {
    velocity_nodes(space, cell, nodes);
    pressure_nodes(space, cell, pressures);
    const bool is_curved = space.mapping->is_curved(cell);
    dealii::FEValues<3>& velocity = is_curved ? curved : straight;
    dealii::FEValues<3>& pressure = is_curved ? curved_pressure : straight_pressure;
    velocity.reinit(cell);
    pressure.reinit(cell);
    add_cell(velocity, pressure, nodes, pressures, system);
  }
  system.ends = edge_ends(space);
  return system;
}

} // namespace reference::stokes_fem
