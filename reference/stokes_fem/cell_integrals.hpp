#pragma once

// Included only by the sources of this folder that speak deal.II.

#include "reference/stokes_fem/discretisation.hpp"

#include <deal.II/fe/fe_values.h>

#include <Eigen/Core>

#include <array>

namespace reference::stokes_fem {

/// Integrals over a cell of its ten quadratic functions phi and four linear ones psi.
struct CellIntegrals {
  Eigen::Matrix<double, 10, 10> stiffness;              // grad phi_i . grad phi_j
  std::array<Eigen::Matrix<double, 4, 10>, 3> coupling; // psi_k d phi_i / d x_c
  Eigen::Matrix<double, 10, 1> velocity_volume;         // phi_i
  Eigen::Vector4d pressure_volume;                      // psi_k
};

/// Integrates over the cells of the mesh that the mapping bends; keeps a reference to it.
class CellIntegrator {
public:
  explicit CellIntegrator(const CurvedMapping& mapping);

  /// Of one cell, valid until the next.
  const CellIntegrals& operator()(const Cell& cell);

private:
  const CurvedMapping& mapping_;
  dealii::FE_SimplexP<3> quadratic_{2};
  dealii::FE_SimplexP<3> linear_{1};
  dealii::MappingFE<3> straight_mapping_;
  dealii::FEValues<3> straight_;
  dealii::FEValues<3> straight_pressure_;
  dealii::FEValues<3> curved_;
  dealii::FEValues<3> curved_pressure_;
  CellIntegrals integrals_;
};

} // namespace reference::stokes_fem
