#include "reference/stokes_fem/schur_complement.hpp"

namespace reference::stokes_fem {

namespace {

using Eigen::VectorXd;

std::array<VectorXd, 3> inverse_diagonals(const VelocityComponents& components) {
  std::array<VectorXd, 3> inverse;
  for (std::size_t c = 0; c < 3; ++c)
    inverse[c] = components[c].laplacian.diagonal().cwiseInverse();
  return inverse;
}

SparseMatrix scaled_laplace(const VelocityComponents& components, const std::array<VectorXd, 3>& inverse_diagonal) {
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

SchurComplement::SchurComplement(const VelocityComponents& components) : components_(components) {
  for (const VelocityComponent& component : components)
    factors_.emplace_back(component.laplacian);
}

Velocity SchurComplement::driven() const {
  Velocity velocity;
  for (std::size_t c = 0; c < 3; ++c)
    velocity[c] = factors_[c].solve(components_[c].load);
  return velocity;
}

Velocity SchurComplement::response(const VectorXd& pressure) const {
  Velocity velocity;
  for (std::size_t c = 0; c < 3; ++c)
    velocity[c] = factors_[c].solve(components_[c].divergence.transpose() * pressure);
  return velocity;
}

VectorXd SchurComplement::divergence(const Velocity& velocity) const {
  VectorXd sum = components_[0].divergence * velocity[0];
  for (std::size_t c = 1; c < 3; ++c)
    sum += components_[c].divergence * velocity[c];
  return sum;
}

double SchurComplement::factor_entries() const {
  double entries = 0;
  for (const Cholesky& factor : factors_)
    entries += factor.entries();
  return entries;
}

CommutatorPreconditioner::CommutatorPreconditioner(const VelocityComponents& components)
    : components_(components), inverse_diagonal_(inverse_diagonals(components)),
      laplace_(scaled_laplace(components, inverse_diagonal_)) {}

VectorXd CommutatorPreconditioner::operator()(const VectorXd& residual) const {
  const VectorXd inner = laplace_.solve(residual);
  VectorXd middle = VectorXd::Zero(residual.size());
  for (std::size_t c = 0; c < 3; ++c) {
    const VelocityComponent& component = components_[c];
    const VectorXd gradient = component.divergence.transpose() * inner;
    const VectorXd scaled = inverse_diagonal_[c].cwiseProduct(gradient);
    const VectorXd applied = component.laplacian.selfadjointView<Eigen::Lower>() * scaled;
    middle += component.divergence * inverse_diagonal_[c].cwiseProduct(applied);
  }
  return laplace_.solve(middle);
}

} // namespace reference::stokes_fem
