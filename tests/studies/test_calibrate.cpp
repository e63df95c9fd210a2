#include "studies/calibration/calibrate.hpp"
#include "studies/calibration/spread_fit.hpp"

#include "pfv/flow/steady_flow.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"

#include <gtest/gtest.h>

namespace studies {
namespace {

KnownFlow by_rule(const pfv::Calibrated& rule, std::uint64_t seed) {
  KnownFlow known{.id = "cell", .problem = {}, .permeability = 0, .error = 0, .force = {}};
  known.problem.packing = pfv::random_packing(
      {.spheres = 20, .solid_fraction = 0.26 + 0.02 * static_cast<double>(seed), .radius_ratio = 1.5, .seed = seed});
  known.problem.faces = pfv::flow_along(pfv::Axis::z);
  pfv::FlowOptions options;
  options.conductance = rule;
  pfv::Clock clock;
  const pfv::SteadyFlow flow = solve_steady_flow(known.problem, options, clock);
  known.permeability = *flow.permeability;
  for (std::size_t k = 0; k < flow.forces.pressure.size(); ++k)
    known.force.push_back(flow.forces.of_flow(k));
  return known;
}

TEST(Calibrate, FindsTheConstantsThatThePermeabilitiesWereMadeWith) {
  pfv::Calibrated rule;
  rule.openness = 3;
  rule.length = .4;
  rule.gap = .5;
  rule.half_gap = .15;
  rule.contrast = 1;
  std::vector<KnownFlow> known;
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    known.push_back(by_rule(rule, seed));
  const Calibration fit = calibrate(known);
  for (const FittedConstant& constant : fitted_constants)
    EXPECT_NEAR(fit.rule.*constant.value, rule.*constant.value, 1e-6) << constant.name;
  for (std::size_t n = 0; n < known.size(); ++n)
    EXPECT_NEAR(fit.left_out[n], 0, 1e-6);
}

TEST(Calibrate, WhatIsLeftOutIsFartherOff) {
  std::vector<KnownFlow> known;
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    known.push_back(by_rule({}, seed));
  known[2].permeability *= 1.1;
  const Calibration fit = calibrate(known);
  for (std::size_t n = 0; n < known.size(); ++n)
    EXPECT_GE(std::abs(fit.left_out[n]), std::abs(fit.difference[n]));
  known.erase(known.begin() + 2); // what the others say of it
  EXPECT_NEAR(fit.left_out[2], std::log(1 / 1.1), .02);
}

TEST(Calibrate, NeedsMorePackingsThanConstants) {
  const std::vector<KnownFlow> as_many(fitted_constants.size(), by_rule({}, 1));
  EXPECT_THROW(calibrate(as_many), pfv::InputError);
}

TEST(SpreadFit, FindsTheShareThatTheForcesWereMadeWith) {
  pfv::Calibrated rule;
  rule.shear_spread = .2;
  std::vector<KnownFlow> known;
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    known.push_back(by_rule(rule, seed));
  const SpreadFit fit = fit_shear_spread(known, {});
  EXPECT_NEAR(fit.share, .2, 1e-9);
  EXPECT_NEAR(fit.standard_error, 0, 1e-9);
  for (std::size_t n = 0; n < known.size(); ++n) {
    EXPECT_GT(fit.by_throat[n], .005);
    EXPECT_NEAR(fit.left_out[n], 0, 1e-6);
  }
  known[0].force[0] *= 1.5;
  EXPECT_GT(fit_shear_spread(known, {}).left_out[0], fit_shear_spread(known, {}).fitted[0]);
  EXPECT_THROW(fit_shear_spread(std::span(known).first(1), {}), pfv::InputError);
}

} // namespace
} // namespace studies
