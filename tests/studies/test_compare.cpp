#include "studies/runner/compare.hpp"

#include "pfv/problem/error.hpp"
#include "tests/studies/example_row.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using studies::compare;
using studies::Finding;
using studies::Outcome;
using studies::Status;
using studies::Tolerance;

const std::string reference_name = "reference";

Finding finding(const std::string& method, double k, std::optional<double> error = std::nullopt) {
  Finding result{"one", method, {example_row(method)}, {}, {}};
  result.permeability = studies::Bounded{k, error, 2};
  return result;
}

Finding without_answer(const std::string& method, Status status) {
  Finding result{"one", method, {example_row(method)}, {}, {}};
  result.rows.front().status = status;
  result.rows.front().message = "the reason";
  return result;
}

TEST(Compare, AgreesWithinTheTolerance) {
  const Finding reference = finding(reference_name, 2, 0.01);
  const auto comparison = compare(finding("m", 2.08, 0.01), reference_name, &reference, Tolerance{0.05, 0.05});
  EXPECT_EQ(comparison.outcome, Outcome::agrees);
  EXPECT_NEAR(comparison.permeability->value, 0.04, 1e-14);
  EXPECT_NEAR(comparison.permeability->error.value(), 0.01, 1e-14); // (0.01 + 0.01) / 2
  EXPECT_FALSE(comparison.permeability->unresolved());
}

TEST(Compare, DiffersBeyondToleranceAndErrorBars) {
  const Finding reference = finding(reference_name, 2, 0.01);
  EXPECT_EQ(compare(finding("m", 2.2, 0.01), reference_name, &reference, {}).outcome, Outcome::differs);
  EXPECT_EQ(compare(finding("m", 1.8, 0.01), reference_name, &reference, {}).outcome, Outcome::differs);
}

TEST(Compare, AgreesWithinTheErrorBars) {
  const Finding reference = finding(reference_name, 2, 0.1);
  const auto comparison = compare(finding("m", 2.2, 0.15), reference_name, &reference, {});
  EXPECT_EQ(comparison.outcome, Outcome::agrees);
  EXPECT_FALSE(comparison.permeability->unresolved());
}

TEST(Compare, ADifferenceBelowTheReferencesOwnErrorIsUnresolved) {
  const Finding reference = finding(reference_name, 2, 0.3);
  const auto comparison = compare(finding("m", 2.2, 0.01), reference_name, &reference, {});
  EXPECT_TRUE(comparison.permeability->unresolved());
  EXPECT_NE(comparison.because.find("unresolved"), std::string::npos);
}

TEST(Compare, WithoutAnErrorBarOfTheReferenceNothingIsUnresolved) {
  const Finding reference = finding(reference_name, 2);
  const auto comparison = compare(finding("m", 2.0001), reference_name, &reference, {});
  EXPECT_FALSE(comparison.permeability->unresolved());
  EXPECT_FALSE(comparison.permeability->error);
  EXPECT_EQ(comparison.outcome, Outcome::agrees);
}

TEST(Compare, OneQuantityThatDiffersIsEnough) {
  Finding reference = finding(reference_name, 2, 0.01);
  Finding other = finding("m", 2, 0.01);
  reference.forces = studies::BoundedField{{0, 0, 1, 0, 0, 2}, 0.001};
  other.forces = studies::BoundedField{{0, 0, 2, 0, 0, 1}, 0.001};
  const auto comparison = compare(other, reference_name, &reference, {});
  EXPECT_EQ(comparison.outcome, Outcome::differs);
  EXPECT_NEAR(comparison.forces->value, std::sqrt(2.0 / 5.0), 1e-14);
}

TEST(Compare, WithoutAnAnswerSaysWhy) {
  const Finding reference = finding(reference_name, 2, 0.01);
  const std::pair<Status, std::optional<Outcome>> expected[] = {{Status::not_covered, Outcome::not_covered},
                                                                {Status::unavailable, Outcome::unavailable},
                                                                {Status::failed, Outcome::failed},
                                                                {Status::over_budget, std::nullopt}};
  for (const auto& [status, outcome] : expected) {
    const auto comparison = compare(without_answer("m", status), reference_name, &reference, {});
    EXPECT_EQ(comparison.outcome, outcome) << name(status);
    EXPECT_EQ(comparison.because, "the reason");
  }
}

TEST(Compare, WithoutAnAnswerOfTheReferenceThereIsNoComparison) {
  const std::pair<Status, Outcome> expected[] = {{Status::not_covered, Outcome::not_covered},
                                                 {Status::unavailable, Outcome::unavailable},
                                                 {Status::failed, Outcome::unavailable},
                                                 {Status::over_budget, Outcome::unavailable}};
  for (const auto& [status, outcome] : expected) {
    const Finding reference = without_answer(reference_name, status);
    EXPECT_EQ(compare(finding("m", 2), reference_name, &reference, {}).outcome, outcome) << name(status);
  }
  EXPECT_EQ(compare(finding("m", 2), reference_name, nullptr, {}).outcome, Outcome::unavailable);
}

TEST(Compare, TheReferenceIsNotComparedWithItself) {
  const Finding reference = finding(reference_name, 2, 0.01);
  EXPECT_FALSE(compare(reference, reference_name, &reference, {}).outcome);
}

TEST(Compare, NoQuantityInCommonIsNotCovered) {
  const Finding reference = finding(reference_name, 2, 0.01);
  Finding other = finding("m", 2);
  other.permeability = std::nullopt;
  EXPECT_EQ(compare(other, reference_name, &reference, {}).outcome, Outcome::not_covered);
}

TEST(Compare, PorePressuresAreMeasuredByTheDrop) {
  Finding reference = finding(reference_name, 2, 0.01);
  Finding other = finding("m", 2, 0.01);
  const double unknown = std::nan("");
  reference.pore_pressures = studies::BoundedField{{1, unknown, 3}, 0.2};
  other.pore_pressures = studies::BoundedField{{2, 5, 3}, 0.2};
  reference.pressure_drop = 10;
  const auto comparison = compare(other, reference_name, &reference, {.pressures = 0.01});
  EXPECT_NEAR(comparison.pressures->value, std::sqrt(0.5) / 10, 1e-14);
  EXPECT_NEAR(*comparison.pressures->reference_error, 0.02, 1e-14);
  EXPECT_EQ(comparison.outcome, Outcome::differs);
}

TEST(Compare, PorePressuresWithoutALevelAreComparedAtTheSameMean) {
  Finding reference = finding(reference_name, 2, 0.01);
  Finding other = finding("m", 2, 0.01);
  const double unknown = std::nan("");
  reference.pore_pressures = studies::BoundedField{{1, unknown, 3}, 0.2};
  other.pore_pressures = studies::BoundedField{{102, 5, 103}, 0.2};
  reference.pressure_drop = 10;
  EXPECT_GT(compare(other, reference_name, &reference, {}).pressures->value, 10);
  other.free_level = true;
  EXPECT_NEAR(compare(other, reference_name, &reference, {}).pressures->value, 0.5 / 10, 1e-14);
}

TEST(Compare, ThroatFluxesAreToldAndNotJudged) {
  Finding reference = finding(reference_name, 2, 0.01);
  Finding other = finding("m", 2, 0.01);
  reference.throat_fluxes = studies::BoundedField{{3, 4}, 0.1};
  other.throat_fluxes = studies::BoundedField{{4, 3}, {}};
  const auto comparison = compare(other, reference_name, &reference, {});
  EXPECT_NEAR(comparison.fluxes->value, std::sqrt(2. / 25), 1e-14);
  EXPECT_EQ(comparison.outcome, Outcome::agrees);
}

TEST(RmsDifference, IsZeroForTheSameAndSkipsWhatIsUnknown) {
  const std::vector<double> values{1, 2, std::nan(""), -4};
  EXPECT_EQ(studies::rms_difference(values, values), 0);
  EXPECT_DOUBLE_EQ(studies::rms(values), std::sqrt(7.0));
  EXPECT_THROW(studies::rms_difference(values, {}), pfv::InputError);
}

TEST(Finding, IsToldOfTheFinestRunThatAnswered) {
  studies::Row coarse = example_row("m", 1.4);
  studies::Row fine = example_row("m", 1.0);
  fine.status = Status::failed;
  fine.message = "no memory";
  const Finding result = studies::find({fine, coarse}, "/nowhere");
  EXPECT_EQ(result.told().mesh_size, 1.4);
  EXPECT_TRUE(result.answered());
  EXPECT_FALSE(result.permeability->error); // one mesh is left
  EXPECT_EQ(result.trouble(), "mesh size 1: failed: no memory");
}

} // namespace
