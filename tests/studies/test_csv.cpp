#include "studies/runner/csv.hpp"

#include <gtest/gtest.h>

namespace {

using studies::CsvRecord;
using studies::parse_csv;
using studies::to_csv;

TEST(Csv, WritesPlainFieldsAsTheyAre) {
  EXPECT_EQ(to_csv({"a", "", "1.5"}), "a,,1.5\n");
}

TEST(Csv, ReadsBackAnyText) {
  const CsvRecord record{"comma, here", "quote \" there", "line\nbreak", "\r\n", "", "\"", ",,", " blank "};
  EXPECT_EQ(parse_csv(to_csv(record)).records, std::vector<CsvRecord>{record});
}

TEST(Csv, ReadsSeveralRecords) {
  const std::vector<CsvRecord> records{{"a", "b"}, {"1\n2", "3"}, {"", ""}};
  std::string text;
  for (const CsvRecord& record : records)
    text += to_csv(record);
  const auto parsed = parse_csv(text);
  EXPECT_EQ(parsed.records, records);
  EXPECT_EQ(parsed.complete_bytes, text.size());
}

TEST(Csv, LeavesOutARecordTornAtAnyByte) {
  const std::string first = to_csv({"whole", "record"});
  const std::string last = to_csv({"torn, \"quoted\"", "line\nbreak", "end"});
  for (std::size_t kept = 0; kept < last.size(); ++kept) {
    const auto parsed = parse_csv(first + last.substr(0, kept));
    ASSERT_EQ(parsed.records.size(), 1U) << kept << " bytes of the last record";
    ASSERT_EQ(parsed.complete_bytes, first.size());
  }
}

} // namespace
