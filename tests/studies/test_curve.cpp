#include "studies/runner/curve.hpp"

#include "studies/document/markdown.hpp"
#include "studies/runner/report.hpp"
#include "tests/studies/example_row.hpp"
#include "tests/studies/study_text.hpp"
#include "tests/studies/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace studies {
namespace {

// Two packings of one label and a third, asked of a formula and of a method with a mesh.
Study example_study() {
  const TemporaryFolder folder;
  Study study = read_study(folder.write("study.toml", study_text));
  study.methods = {{"formula", {1}, {}}, {"meshed", {2, 1}, {}}};
  study.reference = "meshed";
  study.curve = Curve{{"formula"}, "formula"};
  study.cases.resize(2);
  study.cases.push_back(study.cases[1]);
  const char* ids[] = {"a", "b", "c"};
  for (std::size_t i = 0; i < 3; ++i) {
    study.cases[i].id = ids[i];
    study.cases[i].label = i < 2 ? "loose" : "dense";
    study.cases[i].curve = "all";
  }
  return study;
}

/// A packing of Sauter diameter 2 m, on which the methods find these permeabilities (m^2).
void add(std::vector<Result>& results, const std::string& id, double porosity, double formula, double meshed,
         std::optional<double> error = std::nullopt) {
  Row row = example_row("formula");
  row.case_id = id;
  row.porosity = porosity;
  Finding by_formula{id, "formula", {row}, Bounded{formula, std::nullopt, std::nullopt}};
  by_formula.sauter_diameter = 2;
  row.method = "meshed";
  results.push_back({by_formula, {}});
  results.push_back({Finding{id, "meshed", {row}, Bounded{meshed, error, 2.0}}, {}});
}

std::vector<Result> example_results() {
  std::vector<Result> results;
  add(results, "a", 0.5, 4, 8, 0.8);
  add(results, "b", 0.5, 4, 10, 1);
  add(results, "c", 0.4, 2, 3, 0.3);
  return results;
}

TEST(Curve, PointsAreMeansOverCasesOfOneLabelByPorosity) {
  const auto points = curve_points(example_study(), example_results(), "all", "meshed");
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0].label, "dense");
  EXPECT_EQ(points[1].cases, 2U);
  EXPECT_NEAR(points[1].value, 9 / 4.0, 1e-14);
  EXPECT_NEAR(*points[1].ratio, 9 / 4.0, 1e-14);
}

TEST(Curve, BarsAreWhatSeedsSpanAndTheErrorsOfTheAnswers) {
  const auto points = curve_points(example_study(), example_results(), "all", "meshed");
  EXPECT_NEAR(*points[0].error, 0.1 * 3 / 4.0, 1e-14);             // one case: its own
  EXPECT_NEAR(*points[1].error, (1 + 0.1 * 9) / 4.0, 1e-14);       // half of 8 to 10, and a tenth
  EXPECT_NEAR(*points[1].ratio_error, (1 + 0.1 * 9) / 4.0, 1e-14); // over 4
  EXPECT_FALSE(curve_points(example_study(), example_results(), "all", "formula")[0].error);
}

TEST(Curve, LeavesOutWhatHasNoDiameterAndNoPermeability) {
  auto results = example_results();
  results[0].finding.sauter_diameter.reset();
  results[3].finding.permeability.reset();
  const auto points = curve_points(example_study(), results, "all", "meshed");
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0].label, "dense");
}

TEST(Curve, HasNoRatioWhereTheMethodComparedWithDoesNotAnswer) {
  auto results = example_results();
  results[4].finding.permeability.reset();
  const auto points = curve_points(example_study(), results, "all", "meshed");
  EXPECT_FALSE(points[0].ratio);
  EXPECT_TRUE(points[1].ratio);
}

TEST(Curve, IsTwoTablesAndTwoPlots) {
  const Study study = example_study();
  const auto tables = curve_tables(study, example_results());
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[0].title, "all: k / d²");
  EXPECT_EQ(tables[0].table.columns.size(), 5U);
  EXPECT_EQ(tables[0].table.rows[0], (std::vector<std::string>{"loose", "2", "0.500", "1.000", "2.25 ± 0.47"}));
  EXPECT_EQ(tables[1].table.rows[1], (std::vector<std::string>{"dense", "1", "0.400", "1.000", "1.50 ± 0.15"}));
  const auto plots = curve_plots(study, example_results(), "all");
  ASSERT_EQ(plots.size(), 2U);
  EXPECT_EQ(plots[0].y.scale, Scale::logarithmic);
  EXPECT_EQ(plots[0].series[0].drawn, Drawn::line_with_points);
  EXPECT_EQ(plots[0].series[1].drawn, Drawn::points);
}

TEST(Curve, IsOnlyToldWhenTheStudyAsksForIt) {
  Study study = example_study();
  study.curve.reset();
  EXPECT_TRUE(curve_tables(study, example_results()).empty());
  EXPECT_TRUE(curve_plots(study, example_results(), "all").empty());
}

} // namespace
} // namespace studies
