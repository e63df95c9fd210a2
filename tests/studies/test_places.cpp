#include "studies/places/cut_in_space.hpp"
#include "studies/places/place_case.hpp"
#include "studies/places/place_files.hpp"
#include "studies/places/places.hpp"

#include "pfv/problem/error.hpp"
#include "studies/document/markdown.hpp"
#include "studies/runner/case_store.hpp"
#include "studies/runner/csv.hpp"
#include "tests/studies/example_row.hpp"
#include "tests/studies/study_text.hpp"
#include "tests/studies/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace studies {
namespace {

/// Spheres of two sizes in a periodic cell, the pressure rising along z; what two methods say of it is made up: the
/// reference a pressure equal to z and conductances of 1, the other one pressures 5 Pa higher and conductances of 2.
class Places : public testing::Test {
protected:
  Places() {
    const TemporaryFolder folder;
    study = read_study(folder.write("study.toml", study_text));
    study.methods = {{"reference", {1}, {}}, {"other", {1}, {}}};
    study.reference = "reference";
    study.places = {PlaceKind::pores, PlaceKind::spheres, PlaceKind::throats};
    study.cases.resize(1);
    study.cases[0].label = "a cell";
    study.cases[0].toml = R"(
packing = { generator = "random", spheres = 12, solid_fraction = 0.45, radius_ratio = 2, seed = 3 }
flow = { axis = "z", periodic = ["x", "y", "z"] }
)";
    const pfv::Case problem = problem_of(study.cases[0]);
    const double rise = *permeability_setup(problem)->pressure_drop;
    pfv::Clock clock;
    const auto network = build_pore_network(problem.packing, periodic_axes(problem.faces), clock);
    const double length = problem.packing.box.size().z();
    Finding reference{"one", "reference", {example_row("reference")}, Bounded{1, 0.01, 2.0}};
    reference.free_level = true;
    reference.pressure_drop = std::abs(rise);
    reference.pore_pressures = reference.throat_fluxes = reference.forces = reference.viscous_forces = BoundedField{};
    Finding other = reference;
    other.method = "other";
    other.rows = {example_row("other")};
    for (const pfv::Vec3& centre : network.pores.centre) {
      reference.pore_pressures->values.push_back(rise * centre.z() / length);
      other.pore_pressures->values.push_back(rise * centre.z() / length + 5);
    }
    for (std::size_t t = 0; t < network.throats.size(); ++t) {
      const double fall =
          rise *
          (network.pores.centre[static_cast<std::size_t>(network.throats.pores[t][0])] - network.centre_ahead(t)).z() /
          length;
      reference.throat_fluxes->values.push_back(fall);
      other.throat_fluxes->values.push_back(2 * fall);
    }
    for (const pfv::Sphere& sphere : problem.packing.spheres)
      for (const double along : {0.0, 0.0, rise > 0 ? -sphere.radius : sphere.radius}) {
        reference.forces->values.push_back(along);
        other.forces->values.push_back(1.1 * along);
        reference.viscous_forces->values.push_back(0.25 * along);
        other.viscous_forces->values.push_back(0.5 * along);
      }
    results = {{reference, {}}, {other, {}}};
  }

  std::string page() const {
    Document document{"page", {}};
    add_places(study, results, document);
    return to_markdown(document);
  }

  Study study;
  std::vector<Result> results;
};

TEST_F(Places, PressuresWithoutALevelAreComparedAtTheSameMean) {
  const auto cases = place_cases(study, results);
  ASSERT_EQ(cases.size(), 1U);
  const auto pairs = cases[0].pressures();
  ASSERT_EQ(pairs.size(), 1U);
  for (std::size_t i = 0; i < pairs[0].values.size(); ++i)
    EXPECT_NEAR(pairs[0].values[i], pairs[0].reference[i], 1e-12);
}

TEST_F(Places, NothingIsDrawnInSpaceWithoutAnotherMethod) {
  auto cases = place_cases(study, results);
  ASSERT_FALSE(cases.empty());
  cases.front().others.clear();
  EXPECT_TRUE(pressure_in_space(cases).empty());
}

TEST_F(Places, ForcesAreToldAlongTheFlow) {
  const auto cases = place_cases(study, results);
  const auto pairs = cases[0].forces();
  const auto& spheres = cases[0].problem.packing.spheres;
  for (std::size_t k = 0; k < spheres.size(); ++k)
    EXPECT_NEAR(pairs[0].reference[k], spheres[k].radius, 1e-12);
}

TEST_F(Places, ConductancesAreFluxOverTheFallAcrossThePeriodicFaceToo) {
  const auto cases = place_cases(study, results);
  const auto pairs = cases[0].conductances();
  ASSERT_EQ(pairs.size(), 1U);
  std::size_t told = 0, across = 0;
  for (std::size_t t = 0; t < pairs[0].values.size(); ++t) {
    if (std::isnan(pairs[0].reference[t]) || std::abs(pairs[0].reference[t] - 1) > 1e-6) // two pores at one height
      continue;
    EXPECT_NEAR(pairs[0].values[t], 2, 1e-6);
    ++told;
    across += cases[0].network.throats.shift[t][2] != 0 ? 1 : 0;
  }
  EXPECT_GT(told, 0.9 * static_cast<double>(pairs[0].values.size()));
  EXPECT_GT(across, 0U);
}

TEST_F(Places, UnresolvedConductancesAreNotTold) {
  results[0].finding.throat_fluxes->error = 1e6;
  const auto cases = place_cases(study, results);
  for (const double value : cases[0].conductances()[0].reference)
    EXPECT_TRUE(std::isnan(value));
}

TEST_F(Places, ThePageSaysWhatDiffersByHowMuch) {
  const std::string text = page();
  EXPECT_NE(text.find("| a cell | other | 12 | 10 % |  | 10 % | 10 % | 10 % | 10 % |"), std::string::npos) << text;
  EXPECT_NE(text.find("| a cell | other | 45 % | 25 % | 100 % |"), std::string::npos) << text;
  EXPECT_NE(text.find("2.00 (2.00 to 2.00)"), std::string::npos) << text;
  EXPECT_NE(text.find("| a cell | other |"), std::string::npos);
}

TEST_F(Places, OnlyWhatWasAskedIsOnThePage) {
  study.places = {PlaceKind::spheres};
  EXPECT_EQ(page().find("Pressures in pores"), std::string::npos);
  EXPECT_NE(page().find("Forces on spheres"), std::string::npos);
  study.places.clear();
  EXPECT_EQ(page().find("Forces on spheres"), std::string::npos);
}

TEST_F(Places, FilesHaveALineForEachPlaceAndAColumnForEachMethod) {
  const auto files = place_files(study, results);
  ASSERT_EQ(files.size(), 3U);
  const auto spheres = parse_csv(files.at("spheres.csv")).records;
  ASSERT_EQ(spheres.size(), 13U);
  EXPECT_EQ(spheres[0].back(), "other_shear_n");
  EXPECT_EQ(spheres[0].size(), spheres[1].size());
  const auto throats = parse_csv(files.at("throats.csv")).records;
  EXPECT_EQ(throats.size(), results[0].finding.throat_fluxes->values.size() + 1);
}

TEST_F(Places, AnswersOfOtherPoresAreRefused) {
  results[1].finding.pore_pressures->values.pop_back();
  EXPECT_THROW(place_cases(study, results), pfv::InputError);
}

TEST_F(Places, CasesWithoutAnAnswerOfTheReferenceAreLeftOut) {
  results[0].finding.rows[0].status = Status::failed;
  EXPECT_TRUE(place_cases(study, results).empty());
  EXPECT_EQ(page().find("Forces on spheres"), std::string::npos);
}

} // namespace
} // namespace studies
