#pragma once

#include <string>
#include <vector>

namespace studies {

/// A table of texts. An empty cell stays empty.
struct Table {
  struct Column {
    std::string title;
    bool numbers = false; // set to the right
  };
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows; // each as long as `columns`
};

/// For a terminal: columns two blanks apart, a line under the titles.
std::string to_plain(const Table& table);

/// As a Markdown table; a | in a cell is escaped, a line break becomes a blank.
std::string to_markdown(const Table& table);

} // namespace studies
