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

SparseMatrix scaled_laplace(const VelocityComponents& components, const Velocity& inverse_diagonal) {
  const Eigen::Index size = components[0].divergence.rows();
  SparseRows laplace(size, size);
  for (std::size_t c = 0; c < 3; ++c) {
    const SparseRows scaled = components[c].divergence * inverse_diagonal[c].asDiagonal();
    laplace += SparseRows(scaled * SparseRows(components[c].divergence.transpose()));
  }
  SparseMatrix lower = SparseMatrix(laplace).triangularView<Eigen::Lower>();
  // Pockets closed off from every pressure face, and pressures no free velocity sees, leave L singular but the
  // equations consistent: a shift far below L's other eigenvalues keeps the factor finite and the solution what it is.
  const double shift = 1e-10 * lower.diagonal().maxCoeff();
  for (Eigen::Index k = 0; k < size; ++k)
    lower.coeffRef(k, k) += shift;
  return lower;
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

CommutatorPreconditioner::CommutatorPreconditioner(const VelocityComponents& components, const NodeLaplacian& laplacian)
    : components_(components), laplacian_(laplacian), inverse_diagonal_(inverse_diagonals(components, laplacian)),
      laplace_(scaled_laplace(components, inverse_diagonal_)) {}

VectorXd CommutatorPreconditioner::operator()(const VectorXd& residual) const {
  Velocity flow = gradient(components_, laplace_.solve(residual));
  const auto scale = [&] {
    for (std::size_t c = 0; c < 3; ++c)
      flow[c].array() *= inverse_diagonal_[c].array();
  };
  scale();
  flow = laplacian_.scatter(laplacian_ * laplacian_.gather(flow, components_), components_);
  scale();
  return laplace_.solve(divergence(components_, flow));
}

} // namespace reference::stokes_fem
