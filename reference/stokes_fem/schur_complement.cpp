#include "reference/stokes_fem/schur_complement.hpp"

namespace reference::stokes_fem {

namespace {

using Eigen::VectorXd;

Velocity inverse_diagonals(const VelocityComponents& components, const NodeLaplacian& laplacian) {
  Lanes<double> inverse(4, laplacian.mask.cols());
  for (int row = 0; row < laplacian.pattern.rows(); ++row)
    inverse.col(row).setConstant(1 / laplacian.diagonal(row));
  return laplacian.scatter(inverse, components);
}

SparseRows scaled_laplace(const VelocityComponents& components, const Velocity& inverse_diagonal) {
  const Eigen::Index size = components[0].divergence.rows();
  SparseRows laplace(size, size);
  for (std::size_t c = 0; c < 3; ++c) {
    const SparseRows scaled = components[c].divergence * inverse_diagonal[c].asDiagonal();
    laplace += SparseRows(scaled * SparseRows(components[c].divergence.transpose()));
  }
  laplace = SparseRows(SparseMatrix(laplace)); // sorts each row
  // Pockets closed off from every pressure face, and pressures no free velocity sees, leave L singular but the
  // equations consistent: a shift far below L's other eigenvalues keeps the factor finite and the solution what it is.
  SparseRows shift(size, size);
  shift.setIdentity();
  laplace += 1e-10 * laplace.diagonal().maxCoeff() * shift;
  return laplace;
}

} // namespace

VectorXd divergence(const VelocityComponents& components, const Velocity& velocity) {
  VectorXd sum = components[0].divergence * velocity[0];
  for (std::size_t c = 1; c < 3; ++c)
    sum += components[c].divergence * velocity[c];
  return sum;
}

Velocity gradient(const VelocityComponents& components, const VectorXd& pressure) {
  Velocity velocity;
  for (std::size_t c = 0; c < 3; ++c)
    velocity[c] = components[c].divergence.transpose() * pressure;
  return velocity;
}

CommutatorPreconditioner::CommutatorPreconditioner(const VelocityComponents& components, const NodeLaplacian& laplacian,
                                                   const MakePressureSolver& make)
    : components_(components), laplacian_(laplacian), inverse_diagonal_(inverse_diagonals(components, laplacian)),
      laplace_(make(scaled_laplace(components, inverse_diagonal_))) {}

VectorXd CommutatorPreconditioner::operator()(const VectorXd& residual) const {
  Velocity flow = gradient(components_, laplace_->solve(residual));
  const auto scale = [&] {
    for (std::size_t c = 0; c < 3; ++c)
      flow[c].array() *= inverse_diagonal_[c].array();
  };
  scale();
  flow = laplacian_.scatter(laplacian_ * laplacian_.gather(flow, components_), components_);
  scale();
  return laplace_->solve(divergence(components_, flow));
}

} // namespace reference::stokes_fem
