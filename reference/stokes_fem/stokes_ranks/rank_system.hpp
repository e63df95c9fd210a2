#pragma once

#include "reference/stokes_fem/stokes_ranks/mesh_part.hpp"

#include <deal.II/lac/petsc_sparse_matrix.h>
#include <deal.II/lac/petsc_vector.h>

namespace reference::stokes_fem {

/// Stokes' equations of the free unknowns, shared by the ranks: laplacian u - gradient p = load, gradient^T u = 0.
struct RankSystem {
  dealii::PETScWrappers::MPI::SparseMatrix laplacian;        // of all three components, which it does not couple
  dealii::PETScWrappers::MPI::SparseMatrix gradient;         // integral of psi_k d phi_i / d x_c, velocity by pressure
  dealii::PETScWrappers::MPI::Vector load;                   // of the pressure faces and the mean gradient
  std::array<dealii::PETScWrappers::MPI::Vector, 6> outflow; // by pfv::Face: its product with u is the flux out of it
};

/// The equations without their matrices: loads and fluxes but for the mean gradient's.
std::unique_ptr<RankSystem> faces_system(const Boundary& boundary, const pfv::FaceConditions& faces,
                                         const Numbering& numbering, MPI_Comm ranks);

/// Adds what this rank's cells give. Where no face has a pressure, `without_equation` is the pressure held at zero by
/// leaving its equation out, otherwise negative.
void add_cells(const MeshPart& part, const Numbering& numbering, const pfv::Vec3& mean_gradient, int without_equation,
               RankSystem& system);

} // namespace reference::stokes_fem
