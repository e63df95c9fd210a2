#include "studies/runner/scaling.hpp"

#include "studies/document/markdown.hpp"
#include "studies/runner/report.hpp"
#include "tests/studies/example_row.hpp"
#include "tests/studies/study_text.hpp"
#include "tests/studies/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using studies::Row;
using studies::Status;

studies::Study example_study() {
  const TemporaryFolder folder;
  studies::Study study = studies::read_study(folder.write("study.toml", study_text));
  study.methods = {{"ours", {1}, {}}, {"peer", {1}, {}}};
  study.reference = "ours";
  study.scaling = studies::Scaling{"peer", "triangulate"};
  study.cases[0].id = "small";
  study.cases[1].id = "large";
  return study;
}

// Triangulation grows like N, the solve like N^1.5.
Row row(const std::string& method, const std::string& case_id, std::size_t spheres, double factor) {
  Row made = example_row(method);
  const auto n = static_cast<double>(spheres);
  made.case_id = case_id;
  made.convergence_order = std::nullopt;
  made.spheres = spheres;
  made.stages = {{"triangulate", factor * 1e-6 * n},
                 {"solve", factor * 1e-7 * std::pow(n, 1.5)},
                 {"repeat: solve", factor * 2e-7 * n}};
  made.memory_bytes = static_cast<std::size_t>(factor * 100 * n);
  return made;
}

std::vector<Row> example_rows() {
  return {row("ours", "large", 10000, 1), row("ours", "small", 100, 1), row("peer", "large", 10000, 4),
          row("peer", "small", 100, 4)};
}

std::vector<studies::TitledTable> tables_of(const std::vector<Row>& rows, const studies::Study& study) {
  return studies::scaling_tables(study, studies::results(study, rows, "/nowhere"));
}

std::vector<std::string> titles(const studies::Table& table) {
  std::vector<std::string> list;
  for (const auto& column : table.columns)
    list.push_back(column.title);
  return list;
}

TEST(Exponent, IsThatOfAPowerLaw) {
  EXPECT_NEAR(*studies::exponent(10, 3 * std::pow(10, 1.6), 70, 3 * std::pow(70, 1.6)), 1.6, 1e-12);
  EXPECT_NEAR(*studies::exponent(10, 5, 20, 5), 0, 1e-12);
}

TEST(Exponent, NeedsTwoSizesAndPositiveValues) {
  EXPECT_FALSE(studies::exponent(10, 1, 10, 2));
  EXPECT_FALSE(studies::exponent(10, 0, 20, 2));
  EXPECT_FALSE(studies::exponent(10, 1, 20, std::nan("")));
}

TEST(Scaling, IsOnlyToldWhenTheStudyAsksForIt) {
  studies::Study study = example_study();
  EXPECT_FALSE(tables_of(example_rows(), study).empty());
  EXPECT_NE(studies::to_markdown(studies::report(study, {}, example_rows(), "/nowhere")).find("## How cost grows"),
            std::string::npos);
  study.scaling.reset();
  EXPECT_TRUE(tables_of(example_rows(), study).empty());
  EXPECT_EQ(studies::to_markdown(studies::report(study, {}, example_rows(), "/nowhere")).find("## How cost grows"),
            std::string::npos);
}

TEST(Scaling, TellsCostBySizeFromSmallToLarge) {
  const auto tables = tables_of(example_rows(), example_study());
  ASSERT_EQ(tables.size(), 5U);
  EXPECT_EQ(tables[0].title, "ours, CPU seconds by stage");
  EXPECT_EQ(titles(tables[0].table),
            (std::vector<std::string>{"spheres", "triangulate", "solve", "all", "µs per sphere", "all / triangulate",
                                      "repeated step", "memory", "bytes per sphere"}));
  EXPECT_EQ(tables[0].table.rows[0],
            (std::vector<std::string>{"100", "0.0001", "0.0001", "0.0002", "2", "2", "2e-5", "10 kB", "100"}));
  EXPECT_EQ(tables[0].table.rows[1],
            (std::vector<std::string>{"10000", "0.01", "0.1", "0.11", "11", "11", "0.002", "1 MB", "100"}));
}

TEST(Scaling, TellsExponentsByStage) {
  const auto tables = tables_of(example_rows(), example_study());
  EXPECT_EQ(tables[1].title, "ours, exponents");
  EXPECT_EQ(titles(tables[1].table),
            (std::vector<std::string>{"spheres", "triangulate", "solve", "all", "repeated step", "memory"}));
  ASSERT_EQ(tables[1].table.rows.size(), 1U);
  EXPECT_EQ(tables[1].table.rows[0],
            (std::vector<std::string>{"100 to 10000", "1.00", "1.50", "1.37", "1.00", "1.00"}));
}

TEST(Scaling, DividesTheCostOfTheMethodComparedWith) {
  const auto tables = tables_of(example_rows(), example_study());
  EXPECT_EQ(tables.back().title, "peer / method");
  ASSERT_EQ(tables.back().table.rows.size(), 2U);
  EXPECT_EQ(tables.back().table.rows[1], (std::vector<std::string>{"ours", "10000", "4", "4", "4"}));
}

TEST(Scaling, SaysWhyThereIsNoFigure) {
  auto rows = example_rows();
  rows[2].status = Status::unavailable;
  rows[0].stages.pop_back(); // no repeated step
  const auto tables = tables_of(rows, example_study());
  ASSERT_EQ(tables.size(), 4U); // one size is not enough for exponents
  EXPECT_EQ(tables[0].table.rows[1][6], "");
  EXPECT_EQ(tables[2].table.rows[1][3], "unavailable");
  EXPECT_EQ(tables[3].table.rows[1], (std::vector<std::string>{"ours", "10000", "peer unavailable", "", ""}));
  for (const auto& [title, table] : tables)
    for (const auto& line : table.rows)
      EXPECT_EQ(line.size(), table.columns.size()) << title;
}

} // namespace
