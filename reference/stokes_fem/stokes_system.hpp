#pragma once

#include "reference/stokes_fem/discretise.hpp"

#include <Eigen/SparseCore>

#include <array>
#include <vector>

namespace reference::stokes_fem {

using SparseMatrix = Eigen::SparseMatrix<double>;
using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Stokes equations of unit viscosity before boundary conditions, for one scalar velocity space of N nodes and M
/// pressure nodes: sum over j of laplacian_ij u_j,c - sum over k of divergence_c,ki p_k = f_i,c, sum over c and i of
/// divergence_c,ki u_i,c = 0.
struct StokesSystem {
  SparseMatrix laplacian;               // N x N, integral of grad phi_i . grad phi_j, lower triangle only
  std::array<SparseRows, 3> divergence; // M x N, integral of psi_k d phi_i / d x_c
  Eigen::VectorXd node_volume;          // N, integral of phi_i
  Eigen::VectorXd pressure_volume;      // M, integral of psi_k; its sum is the volume of the curved mesh
  std::vector<std::array<int, 2>> ends; // N, the corners of the edge that a velocity node is the middle of; a corner
                                        // is twice its own
};

/// The Laplacian form of the viscous term: with no-slip grains and flat slip and pressure planes it has the same
/// solution as the symmetric one, and its three components share one matrix.
StokesSystem assemble(const Discretisation& discretisation);

} // namespace reference::stokes_fem
