#include "studies/runner/report.hpp"

#include "studies/document/markdown.hpp"
#include "studies/runner/result_table.hpp"
#include "tests/studies/example_row.hpp"
#include "tests/studies/study_text.hpp"
#include "tests/studies/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace {

using studies::Row;
using studies::Status;

studies::Study example_study() {
  const TemporaryFolder folder;
  studies::Study study = studies::read_study(folder.write("study.toml", study_text));
  study.methods = {{"pore_volumes", {1}, {}}, {"exact", {2, 1}, {}}, {"openfoam", {1}, {}}};
  study.cases.front().published = {{"pore_volumes", 45, 0.00022}, {"openfoam", std::nullopt, std::nullopt}};
  return study;
}

std::vector<Row> example_rows() {
  Row without_mesh = example_row("pore_volumes");
  without_mesh.convergence_order = std::nullopt;
  Row coarse = example_row("exact", 2);
  coarse.permeability = 0.34;
  Row not_run = example_row("openfoam");
  not_run.status = Status::over_budget;
  not_run.message = "expected 5e6 unknowns, 9000 CPU s, 12 GB";
  return {without_mesh, coarse, example_row("exact", 1), not_run};
}

// The lines of a section, without its title.
std::vector<std::string> section(const std::string& text, const std::string& title) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("#"))
      inside = line == title;
    else if (inside && !line.empty())
      lines.push_back(line);
  }
  return lines;
}

TEST(ResultTable, HasALineForEveryMethodAndEveryCellHasAColumn) {
  const studies::Study study = example_study();
  const auto table = studies::result_table(study, studies::results(study, example_rows(), "/nowhere"));
  ASSERT_EQ(table.rows.size(), 3U);
  for (const auto& row : table.rows)
    ASSERT_EQ(row.size(), table.columns.size());
  const auto column = [&](const std::string& title) {
    const auto found = std::ranges::find(table.columns, title, &studies::Table::Column::title);
    EXPECT_NE(found, table.columns.end()) << title;
    return static_cast<std::size_t>(found - table.columns.begin());
  };
  EXPECT_EQ(table.rows[0][column("published dofs")], "45");
  EXPECT_EQ(table.rows[0][column("published s")], "0.00022");
  EXPECT_EQ(table.rows[1][column("published dofs")], ""); // the publication has no such row
  EXPECT_EQ(table.rows[2][column("published dofs")], "n.a.");
  EXPECT_EQ(table.rows[1][column("outcome")], "reference");
  EXPECT_NE(table.rows[1][column("k [m²]")].find("±"), std::string::npos);
  EXPECT_EQ(table.rows[2][column("outcome")], "not run: over budget (expected 5e6 unknowns, 9000 CPU s, 12 GB)");
  EXPECT_EQ(table.rows[2][column("dofs")], "");
}

TEST(ResultTable, LeavesPublishedColumnsOutWhenThereAreNone) {
  studies::Study study = example_study();
  study.cases.front().published.clear();
  const auto table = studies::result_table(study, studies::results(study, example_rows(), "/nowhere"));
  for (const auto& column : table.columns)
    EXPECT_FALSE(column.title.starts_with("published"));
}

TEST(Report, HasQuestionTableSentencesRunsAndProvenance) {
  const studies::Study study = example_study();
  const std::string text = studies::to_markdown(studies::report(study, {}, example_rows(), "/nowhere"));
  EXPECT_TRUE(text.starts_with("# A study\n\nDoes the harness work?\n"));
  EXPECT_EQ(section(text, "## What the comparisons say").size(), 3U);
  EXPECT_EQ(section(text, "## Runs").size(), 2 + example_rows().size());
  const auto provenance = section(text, "## Where the numbers come from");
  for (const char* fact : {"abc-dirty", "GNU 12", "-O3", "a processor, 2 cores", "2000-01-01", "1912"})
    EXPECT_TRUE(std::ranges::any_of(provenance, [&](auto& line) { return line.find(fact) != line.npos; })) << fact;
}

TEST(Report, EveryTableLineHasAsManyCellsAsItsHead) {
  const std::string text = studies::to_markdown(studies::report(example_study(), {}, example_rows(), "/nowhere"));
  std::istringstream in(text);
  std::ptrdiff_t bars = 0;
  for (std::string line; std::getline(in, line);) {
    const auto here = std::ranges::count(line, '|');
    if (here > 0 && bars > 0) {
      EXPECT_EQ(here, bars) << line;
    }
    bars = here;
  }
}

TEST(ResultsJson, HasTheSameLines) {
  const studies::Study study = example_study();
  const auto list = studies::results(study, example_rows(), "/nowhere");
  const auto json = nlohmann::json::parse(studies::results_json(study, list));
  ASSERT_EQ(json["results"].size(), 3U);
  EXPECT_EQ(json["results"][1]["method"], "exact");
  EXPECT_TRUE(json["results"][1]["outcome"].is_null());
  EXPECT_EQ(json["results"][2]["status"], "not run: over budget");
}

} // namespace
