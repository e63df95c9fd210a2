#include "studies/runner/row.hpp"

#include "pfv/problem/error.hpp"
#include "tests/studies/example_row.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace {

using studies::Row;

TEST(Row, ReadsBackEveryColumnToTheLastDigit) {
  const Row row = example_row();
  EXPECT_EQ(studies::row_from(studies::to_record(row)), row);
}

TEST(Row, ReadsBackTroubleAndAbsence) {
  Row row = example_row();
  for (const studies::Status status : studies::all_statuses) {
    row.status = status;
    row.message = "it said: \"no\",\nthen = ; nothing";
    row.permeability = std::nullopt;
    row.convergence_order = std::nullopt;
    row.stages = {{"a = b", 1}, {"c", 0}};
    const auto parsed = studies::parse_csv(studies::to_csv(studies::to_record(row)));
    ASSERT_EQ(parsed.records.size(), 1U);
    EXPECT_EQ(studies::row_from(parsed.records.front()), row);
  }
}

TEST(Row, ReadsBackInfinity) {
  Row row = example_row();
  row.estimated_cpu_seconds = std::numeric_limits<double>::infinity();
  EXPECT_EQ(studies::row_from(studies::to_record(row)), row);
}

TEST(Row, NamesTheColumnItCannotRead) {
  auto record = studies::to_record(example_row());
  for (std::size_t i = 0; i < record.size(); ++i)
    if (studies::row_columns()[i] == "spheres")
      record[i] = "nine";
  try {
    studies::row_from(record);
    FAIL();
  } catch (const pfv::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("column spheres: 'nine'"), std::string::npos) << error.what();
  }
}

} // namespace
