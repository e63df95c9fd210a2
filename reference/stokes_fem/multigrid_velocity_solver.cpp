#include "pfv/problem/error.hpp"
#include "reference/stokes_fem/velocity_multigrid.hpp"
#include "reference/stokes_fem/velocity_solver.hpp"

#include <cmath>

namespace reference::stokes_fem {

namespace {

double dot(const Lanes<double>& a, const Lanes<double>& b) {
  return (a * b).sum();
}

class MultigridVelocitySolver final : public VelocitySolver {
public:
  MultigridVelocitySolver(const NodeLaplacian& laplacian, const VelocityComponents& components,
                          const std::vector<std::array<int, 2>>& ends)
      : laplacian_(laplacian), components_(components), precondition_(laplacian, ends) {}

  Velocity solve(const Velocity& load, double tolerance) const override {
    constexpr int most = 1000;
    Lanes<double> residual = laplacian_.gather(load, components_);
    Lanes<double> x = Lanes<double>::Zero(4, residual.cols());
    const double goal = tolerance * tolerance * dot(residual, residual);
    Lanes<double> direction;
    double previous = 0;
    for (int iteration = 0; dot(residual, residual) > goal; ++iteration) {
      if (iteration == most)
        throw pfv::SolveError("the multigrid of the velocities does not converge in " + std::to_string(most) +
                              " iterations");
      const Lanes<double> preconditioned = precondition_(residual);
      const double energy = dot(residual, preconditioned);
      if (iteration == 0)
        direction = preconditioned;
      else
        direction = preconditioned + energy / previous * direction;
      previous = energy;
      const Lanes<double> applied = laplacian_ * direction;
      const double step = energy / dot(direction, applied);
      if (!std::isfinite(step))
        throw pfv::SolveError("the multigrid of the velocities breaks down: a Laplacian is singular");
      x += step * direction;
      residual -= step * applied;
      ++iterations_;
    }
    return laplacian_.scatter(x, components_);
  }

  int iterations() const override { return iterations_; }

private:
  const NodeLaplacian& laplacian_;
  const VelocityComponents& components_;
  VelocityMultigrid precondition_;
  mutable int iterations_ = 0;
};

} // namespace

std::unique_ptr<VelocitySolver> make_multigrid_velocity_solver(const NodeLaplacian& laplacian,
                                                               const VelocityComponents& components,
                                                               const std::vector<std::array<int, 2>>& ends) {
  return std::make_unique<MultigridVelocitySolver>(laplacian, components, ends);
}

} // namespace reference::stokes_fem
