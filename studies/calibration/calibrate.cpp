#include "studies/calibration/calibrate.hpp"

#include "pfv/flow/steady_flow.hpp"
#include "pfv/problem/error.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <cmath>

namespace studies {

namespace {

constexpr int constants = static_cast<int>(fitted_constants.size());
constexpr double probe = 1e-3; // of the rule's own constant, either way
constexpr double settled = 1e-7;
constexpr int most_steps = 20;

using Constants = Eigen::Vector<double, constants>;

Constants constants_of(const pfv::Calibrated& rule) {
  Constants values;
  for (int c = 0; c < constants; ++c)
    values[c] = rule.*fitted_constants[c].value;
  return values;
}

pfv::Calibrated rule_with(const Constants& values) {
  pfv::Calibrated rule;
  for (int c = 0; c < constants; ++c)
    rule.*fitted_constants[c].value = values[c];
  return rule;
}

double difference(const KnownFlow& known, const Constants& values) {
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

Linearised linearise(std::span<const KnownFlow> packings, const Constants& values) {
  const auto count = static_cast<Eigen::Index>(packings.size());
  const Constants step = probe * constants_of({});
  Linearised result{Eigen::VectorXd(count), Eigen::Matrix<double, Eigen::Dynamic, constants>(count, constants)};
  for (Eigen::Index n = 0; n < count; ++n) {
    const auto& known = packings[static_cast<std::size_t>(n)];
    result.difference[n] = difference(known, values);
    for (int c = 0; c < constants; ++c) {
      const Constants away = step[c] * Constants::Unit(c);
      result.slope(n, c) = (difference(known, values + away) - difference(known, values - away)) / (2 * step[c]);
    }
  }
  return result;
}

} // namespace

Calibration calibrate(std::span<const KnownFlow> packings) {
  if (packings.size() <= constants)
    throw pfv::InputError(fmt::format("{} packings: a fit of {} constants needs more", packings.size(), constants));
  Constants values = constants_of({});
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
  const Eigen::Matrix<double, constants, constants> inverse = (at.slope.transpose() * at.slope).inverse();
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
