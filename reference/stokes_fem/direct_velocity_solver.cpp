#include "reference/stokes_fem/cholesky.hpp"
#include "reference/stokes_fem/velocity_solver.hpp"

namespace reference::stokes_fem {

namespace {

SparseMatrix restrict_lower(const SparseMatrix& full, const VelocityComponent& component) {
  SparseMatrix part(component.size, component.size);
  part.reserve(full.nonZeros());
  for (Eigen::Index column = 0; column < full.outerSize(); ++column) {
    const int free_column = component.free_index[static_cast<std::size_t>(column)];
    if (free_column < 0)
      continue;
    part.startVec(free_column);
    for (SparseMatrix::InnerIterator it(full, column); it; ++it)
      if (const int row = component.free_index[static_cast<std::size_t>(it.row())]; row >= 0)
        part.insertBack(row, free_column) = it.value();
  }
  part.finalize();
  return part;
}

class DirectVelocitySolver final : public VelocitySolver {
public:
  DirectVelocitySolver(const SparseMatrix& lower, const VelocityComponents& components) {
    for (const VelocityComponent& component : components)
      factors_.emplace_back(restrict_lower(lower, component));
  }

  Velocity solve(const Velocity& load, double) const override {
    Velocity velocity;
    for (std::size_t c = 0; c < 3; ++c)
      velocity[c] = factors_[c].solve(load[c]);
    return velocity;
  }

  double factor_entries() const override {
    double entries = 0;
    for (const Cholesky& factor : factors_)
      entries += factor.entries();
    return entries;
  }

private:
  std::vector<Cholesky> factors_;
};

} // namespace

std::unique_ptr<VelocitySolver> make_direct_velocity_solver(const SparseMatrix& lower,
                                                            const VelocityComponents& components) {
  return std::make_unique<DirectVelocitySolver>(lower, components);
}

} // namespace reference::stokes_fem
