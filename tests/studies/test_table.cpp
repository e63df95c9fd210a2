#include "studies/document/table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace {

const studies::Table table{{{"name"}, {"value", true}},
                           {{"a", "1"}, {"longer than the title", "12.5 ± 0.1"}, {"", ""}}};

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> list;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    list.push_back(line);
  return list;
}

TEST(Table, PlainColumnsStartAndEndAtTheSamePlace) {
  const auto text = lines(studies::to_plain(table));
  ASSERT_EQ(text.size(), 5U); // titles, rule, three rows
  EXPECT_EQ(text[1], std::string(21, '-') + "  " + std::string(10, '-'));
  EXPECT_EQ(text[0].size(), text[1].size()); // numbers end at the right edge
  EXPECT_EQ(text[2].size(), text[1].size());
  EXPECT_EQ(text[3].size(), text[1].size() + 1); // ± takes two bytes and one place
  EXPECT_EQ(text[4], "");
}

TEST(Table, MarkdownHasTheSameNumberOfCellsInEveryLine) {
  const auto text = lines(studies::to_markdown(table));
  ASSERT_EQ(text.size(), 5U);
  for (const std::string& line : text)
    EXPECT_EQ(std::ranges::count(line, '|'), 3) << line;
  EXPECT_EQ(text[1], "| --- | ---: |");
}

TEST(Table, MarkdownCellsCannotBreakTheTable) {
  const auto text = lines(studies::to_markdown({{{"a"}}, {{"one | two\nthree"}}}));
  ASSERT_EQ(text.size(), 3U);
  EXPECT_EQ(text[2], "| one \\| two three |");
}

} // namespace
