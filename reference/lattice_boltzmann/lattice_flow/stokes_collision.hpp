#pragma once

#include "reference/lattice_boltzmann/velocities.hpp"

#include <array>

namespace reference::lattice_boltzmann {

/// Collision with two relaxation times (Ginzburg, Verhaeghe and d'Humieres 2008) towards the equilibrium of Stokes
/// flow, t (rho + 3 c.u): linear, so that the answer is exactly proportional to the force. Even parts relax with
/// omega+ = 1 / (3 nu + 1/2), odd ones so that (1/omega+ - 1/2) (1/omega- - 1/2) is the magic parameter. The body force
/// enters as Guo, Zheng and Shi 2002 have it: u = sum f c + force / 2.
class StokesCollision {
public:
  using Vector = std::array<double, 3>;

  StokesCollision(double viscosity, double magic, const Vector& force)
      : viscosity_(viscosity), magic_(magic), even_(1 / (3 * viscosity + 0.5)),
        odd_(1 / (magic / (3 * viscosity) + 0.5)), force_(force) {}

  double viscosity() const { return viscosity_; }
  double magic() const { return magic_; }
  double even() const { return even_; }
  const Vector& force() const { return force_; }

  /// The populations of fluid that the force has not moved yet. Starting from others, voxels open along one line only
  /// would swing for ever across it.
  double at_rest(std::size_t direction) const {
    const Step& c = steps[direction];
    return -1.5 * weight(direction) * (c[0] * force_[0] + c[1] * force_[1] + c[2] * force_[2]);
  }

  template <typename Populations>
  static double density(const Populations& f) {
    double sum = f[0];
    for (std::size_t i = 1; i <= pairs; ++i)
      sum += f[i] + f[i + pairs];
    return sum;
  }

  template <typename Populations>
  Vector velocity(const Populations& f) const {
    std::array<double, pairs + 1> d;
    for (std::size_t i = 1; i <= pairs; ++i)
      d[i] = f[i + pairs] - f[i];
    return {d[1] + d[4] + d[5] + d[6] + d[7] + force_[0] / 2, d[2] + d[4] - d[5] + d[8] + d[9] + force_[1] / 2,
            d[3] + d[6] - d[7] + d[8] - d[9] + force_[2] / 2};
  }

  template <typename Populations>
  void operator()(Populations& f) const {
    const double rho = density(f);
    const Vector u = velocity(f);
    // Odd equilibrium and force in one: 3 t c.(omega- u + (1 - omega-/2) force).
    Vector drive;
    for (std::size_t a = 0; a < 3; ++a)
      drive[a] = 3 * (odd_ * u[a] + (1 - odd_ / 2) * force_[a]);
    f[0] += even_ * (rho / 3 - f[0]);
    const auto relax = [&](std::size_t i, double t, double along) {
      const double plus = even_ * (0.5 * (f[i] + f[i + pairs]) - t * rho);
      const double minus = odd_ * 0.5 * (f[i] - f[i + pairs]) - t * along;
      f[i] -= plus + minus;
      f[i + pairs] -= plus - minus;
    };
    relax(1, 1. / 18, -drive[0]);
    relax(2, 1. / 18, -drive[1]);
    relax(3, 1. / 18, -drive[2]);
    relax(4, 1. / 36, -drive[0] - drive[1]);
    relax(5, 1. / 36, -drive[0] + drive[1]);
    relax(6, 1. / 36, -drive[0] - drive[2]);
    relax(7, 1. / 36, -drive[0] + drive[2]);
    relax(8, 1. / 36, -drive[1] - drive[2]);
    relax(9, 1. / 36, -drive[1] + drive[2]);
  }

private:
  double viscosity_;
  double magic_;
  double even_;
  double odd_;
  Vector force_;
};

} // namespace reference::lattice_boltzmann
