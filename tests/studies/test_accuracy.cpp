#include "studies/runner/accuracy.hpp"

#include "tests/studies/example_row.hpp"
#include "tests/studies/study_text.hpp"
#include "tests/studies/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace studies {
namespace {

Row run(const std::string& case_id, const std::string& method, double k, double cpu_seconds) {
  Row row = example_row(method);
  row.case_id = case_id;
  row.permeability = k;
  row.stages = {{"mesh", cpu_seconds / 2}, {"solve", cpu_seconds / 2}};
  return row;
}

Study example_study() {
  const TemporaryFolder folder;
  Study study = read_study(folder.write("study.toml", study_text));
  study.methods = {{"meshed", {4, 2, 1}, {}}, {"other", {2, 1}, {}}};
  study.reference = "meshed";
  study.accuracy = Accuracy{{0.1, 0.01}};
  return study;
}

/// k = 1 m^2 in both cases, known to 1e-3 in the first and to 0.02 in the second.
std::vector<Result> example_results() {
  std::vector<Result> results;
  const auto reference = [&](const std::string& id, double error) {
    results.push_back({Finding{id,
                               "meshed",
                               {run(id, "meshed", 1.2, 1), run(id, "meshed", 1.05, 4), run(id, "meshed", 1.005, 16)},
                               Bounded{1, error, 2.0}},
                       {}});
  };
  reference("one", 1e-3);
  results.push_back(
      {Finding{"one", "other", {run("one", "other", 0.8, 2), run("one", "other", 0.95, 8)}, Bounded{1.008, 0.1, 2.0}},
       {}});
  reference("two", 0.02);
  return results;
}

std::vector<double> seconds_of(const std::string& method, double level, bool extrapolated = false) {
  return cost_of_accuracy(example_study(), example_results(), method, level, extrapolated).cpu_seconds;
}

TEST(Accuracy, CostsTheCoarsestRunThatIsSurelyWithinTheLevel) {
  EXPECT_EQ(seconds_of("meshed", 0.1), (std::vector<double>{4, 4}));
  EXPECT_EQ(seconds_of("other", 0.1), std::vector<double>{8});
  EXPECT_TRUE(seconds_of("other", 0.05).empty()); // 0.05 off, and the reference 0.001
  EXPECT_EQ(seconds_of("other", 0.0511), std::vector<double>{8});
}

TEST(Accuracy, ARunThatIsRightByLuckDoesNotCount) {
  std::vector<Result> results = example_results();
  results[1].finding.rows[0].permeability = 1; // on the coarse mesh only
  const auto found = cost_of_accuracy(example_study(), results, "other", 0.03, false);
  EXPECT_EQ(found.cases, 1U);
  EXPECT_TRUE(found.cpu_seconds.empty());
}

TEST(Accuracy, AReferenceThatIsItselfTooFarOffTellsNothing) {
  const auto found = cost_of_accuracy(example_study(), example_results(), "meshed", 0.01, false);
  EXPECT_EQ(found.cases, 1U);
  EXPECT_EQ(found.cpu_seconds, std::vector<double>{16});
}

TEST(Accuracy, AnExtrapolationCostsAllItsMeshes) {
  EXPECT_EQ(seconds_of("other", 0.01, true), std::vector<double>{10});
  EXPECT_EQ(seconds_of("meshed", 0.01, true), std::vector<double>{21});
}

TEST(Accuracy, TheTableSaysInHowManyCasesALevelIsReached) {
  Study study = example_study();
  std::vector<Result> results = example_results();
  results[2].finding.rows.resize(1); // only the run that is 20 % off
  const Table table = accuracy_table(study, results);
  ASSERT_EQ(table.columns.size(), 3U);
  EXPECT_EQ(table.columns[1].title, "within 10 %");
  ASSERT_EQ(table.rows.size(), 4U);
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"meshed", "4 (in 1 of 2)", "16"}));
  EXPECT_EQ(table.rows[2], (std::vector<std::string>{"other", "8", "in none"}));
  study.accuracy.reset();
  EXPECT_TRUE(accuracy_table(study, results).rows.empty());
}

} // namespace
} // namespace studies
