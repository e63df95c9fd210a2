#include "studies/calibration/calibrate.hpp"

#include "pfv/flow/steady_flow.hpp"
#include "pfv/problem/error.hpp"
#include "pfv/problem/generate.hpp"

#include <gtest/gtest.h>

namespace studies {
namespace {

KnownPermeability by_rule(const pfv::Calibrated& rule, std::uint64_t seed) {
  KnownPermeability known{.id = "cell", .problem = {}, .permeability = 0, .error = 0};
  known.problem.packing = pfv::random_packing(
      {.spheres = 20, .solid_fraction = 0.26 + 0.02 * static_cast<double>(seed), .radius_ratio = 1.5, .seed = seed});
  known.problem.faces = pfv::flow_along(pfv::Axis::z);
  pfv::FlowOptions options;
  options.conductance = rule;
  pfv::Clock clock;
  known.permeability = *solve_steady_flow(known.problem, options, clock).permeability;
  return known;
}

TEST(Calibrate, FindsTheConstantsThatThePermeabilitiesWereMadeWith) {
  pfv::Calibrated rule;
  rule.openness = 3;
  rule.length = .4;
  rule.gap = .5;
  rule.half_gap = .15;
  rule.contrast = 1;
  std::vector<KnownPermeability> known;
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    known.push_back(by_rule(rule, seed));
  const Calibration fit = calibrate(known);
  for (const FittedConstant& constant : fitted_constants)
    EXPECT_NEAR(fit.rule.*constant.value, rule.*constant.value, 1e-6) << constant.name;
  for (std::size_t n = 0; n < known.size(); ++n)
    EXPECT_NEAR(fit.left_out[n], 0, 1e-6);
}

TEST(Calibrate, WhatIsLeftOutIsFartherOff) {
  std::vector<KnownPermeability> known;
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
  const std::vector<KnownPermeability> as_many(fitted_constants.size(), by_rule({}, 1));
  EXPECT_THROW(calibrate(as_many), pfv::InputError);
}

} // namespace
} // namespace studies
