#include "pfv/simulation/pore_fluid.hpp"

#include "pfv/simulation/solid_term.hpp"

#include <cmath>
#include <numeric>

namespace pfv {

double PoreFluid::largest_rate(std::span<const double> per_mass, double longest, Clock& clock) {
  const auto timing = clock.stage("stable step");
  constexpr int most_steps = 100;
  constexpr double settled = 1e-3, tolerance = 1e-4;
  const auto size = static_cast<Eigen::Index>(system_.unknowns());
  if (size == 0)
    return 0;
  const GramTerm solid = solid_term(flux_, system_, per_mass, 1), none;
  FlowMatrix stored;
  const FlowMatrix& matrix = with_storage(0.5 * longest, stored);
  PressureSolver solver;
  solver.set(matrix, none);
  if (mode_.size() != size) {
    mode_.resize(size);
    for (Eigen::Index i = 0; i < size; ++i)
      mode_[i] = std::sin(1.0 + 2.0 * static_cast<double>(i));
  }
  double rate = 0;
  Eigen::VectorXd resisted, pushed;
  for (int n = 0; n < most_steps; ++n) {
    // x -> A^-1 B M^-1 B^T x, whose Rayleigh quotient in the norm of A is x.B M^-1 B^T x / x.A x.
    const double power = multiply(matrix, none, mode_, of_block_, resisted);
    const double next = multiply(matrix, solid, mode_, of_block_, pushed) / power - 1;
    pushed -= resisted;
    mode_ *= next;
    solver.solve(pushed, tolerance, mode_);
    mode_ /= mode_.norm();
    const bool done = std::abs(next - rate) < settled * next && n > 10;
    rate = next;
    if (done)
      break;
  }
  return rate;
}

double PoreFluid::mean_pressure() const {
  const auto& volume = network_.pores.void_volume;
  return std::inner_product(volume.begin(), volume.end(), pressure_.begin(), 0.0) /
         std::reduce(volume.begin(), volume.end());
}

double PoreFluid::inflow_power(std::span<const Vec3> velocity) {
  if (!drives_)
    return 0;
  const auto imposed = [&](std::size_t pore) {
    const auto* known = system_.known(pore);
    return known && known->source >= 0 ? known->pressure : 0;
  };
  double power = 0;
  volume_rates(flux_, velocity, rate_);
  for (std::size_t i = 0; i < network_.pores.size(); ++i)
    power += imposed(i) * rate_[i];
  for (std::size_t t = 0; t < network_.throats.size(); ++t) {
    const auto [i, j] = network_.throats.pores[t];
    power += system_.conductance[t] * (pressure_[i] - pressure_[j]) * (imposed(i) - imposed(j));
  }
  return power;
}

double PoreFluid::dissipation() const {
  double power = 0;
  for (std::size_t t = 0; t < network_.throats.size(); ++t) {
    const auto [i, j] = network_.throats.pores[t];
    const double drop = pressure_[i] - pressure_[j];
    power += system_.conductance[t] * drop * drop;
  }
  return power;
}

} // namespace pfv
