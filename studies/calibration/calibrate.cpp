#include "studies/calibration/calibrate.hpp"

#include "pfv/flow/steady_flow.hpp"
#include "pfv/problem/error.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <cmath>

namespace studies {

namespace {

constexpr int constants = 3;
constexpr double probe = 1e-3; // of a constant, either way
constexpr double settled = 1e-7;
constexpr int most_steps = 20;

using Constants = Eigen::Vector<double, constants>;

pfv::Calibrated rule_with(const Constants& values) {
  pfv::Calibrated rule;
  rule.openness = values[0];
  rule.length = values[1];
  rule.gap = values[2];
  return rule;
}

double difference(const KnownPermeability& known, const Constants& values) {
  pfv::FlowOptions options;
  options.conductance = rule_with(values);
  options.solver = pfv::Cholmod{};
  pfv::Clock clock;
  return std::log(*solve_steady_flow(known.problem, options, clock).permeability / known.permeability);
}

/// Differences of all packings, and how they change with the constants.
struct Linearised {
  Eigen::VectorXd difference;
  Eigen::Matrix<double, Eigen::Dynamic, constants> slope;
};

Linearised linearise(std::span<const KnownPermeability> packings, const Constants& values) {
  const auto count = static_cast<Eigen::Index>(packings.size());
  Linearised result{Eigen::VectorXd(count), Eigen::Matrix<double, Eigen::Dynamic, constants>(count, constants)};
  for (Eigen::Index n = 0; n < count; ++n) {
    const auto& known = packings[static_cast<std::size_t>(n)];
    result.difference[n] = difference(known, values);
    for (int c = 0; c < constants; ++c) {
      const Constants away = probe * Constants::Unit(c);
      result.slope(n, c) = (difference(known, values + away) - difference(known, values - away)) / (2 * probe);
    }
  }
  return result;
}

} // namespace

Calibration calibrate(std::span<const KnownPermeability> packings) {
  if (packings.size() <= constants)
    throw pfv::InputError(fmt::format("{} packings: a fit of {} constants needs more", packings.size(), constants));
  const pfv::Calibrated start;
  Constants values{start.openness, start.length, start.gap};
  Linearised at = linearise(packings, values);
  for (int step = 0;; ++step) {
    const Constants change = -at.slope.colPivHouseholderQr().solve(at.difference);
    if (change.norm() < settled)
      break;
    if (step == most_steps)
      throw pfv::SolveError(fmt::format("the fit does not settle in {} steps", most_steps));
    values += change;
    at = linearise(packings, values);
  }
  const Eigen::Matrix3d inverse = (at.slope.transpose() * at.slope).inverse();
  const double variance = at.difference.squaredNorm() / static_cast<double>(packings.size() - constants);
  Calibration result{.rule = rule_with(values), .standard_error = {}, .difference = {}, .left_out = {}};
  for (int c = 0; c < constants; ++c)
    result.standard_error[c] = std::sqrt(variance * inverse(c, c));
  for (Eigen::Index n = 0; n < at.difference.size(); ++n) {
    const double leverage = at.slope.row(n) * inverse * at.slope.row(n).transpose();
    result.difference.push_back(at.difference[n]);
    result.left_out.push_back(at.difference[n] / (1 - leverage));
  }
  return result;
}

} // namespace studies
