#include "readme/columns.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <stdexcept>

namespace readme {

namespace {

bool matches(const std::string& cell, const std::string& words) {
  return std::ranges::any_of(cells_of(words, '|'), [&](const std::string& word) {
    return word.ends_with('*') ? cell.starts_with(word.substr(0, word.size() - 1)) : cell == word;
  });
}

bool has_all(const std::vector<std::string>& cells, const std::vector<std::string>& words) {
  return std::ranges::all_of(words, [&](const std::string& word) {
    return std::ranges::any_of(cells, [&](const std::string& cell) { return matches(cell, word); });
  });
}

void add_number(const std::string& cell, std::vector<double>& numbers) {
  double number = 0;
  const char* const last = cell.data() + cell.size();
  const auto [end, error] = std::from_chars(cell.data() + cell.starts_with('+'), last, number);
  if (error == std::errc() && end == last)
    numbers.push_back(number);
}

} // namespace

std::vector<std::string> cells_of(std::string_view row, char separator) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : row) {
    quoted ^= c == '"';
    if (c == separator && !quoted)
      cells.emplace_back();
    else
      cells.back() += c;
  }
  return cells;
}

std::vector<double> column(const std::filesystem::path& file, const std::string& title,
                           const std::vector<std::string>& words) {
  std::ifstream in(file);
  if (!in)
    throw std::runtime_error("no results in " + file.string());
  std::vector<std::string> titles;
  std::vector<double> numbers;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#'))
      continue;
    const auto cells = cells_of(line, ',');
    if (titles.empty()) {
      titles = cells;
      if (std::ranges::find(titles, title) == titles.end())
        throw std::runtime_error("no column " + title + " in " + file.string());
    } else if (has_all(cells, words))
      for (std::size_t i = 0; i < std::min(cells.size(), titles.size()); ++i)
        if (titles[i] == title)
          add_number(cells[i], numbers);
  }
  if (numbers.empty())
    throw std::runtime_error("no number in the column " + title + " of " + file.string() + " in the rows asked for");
  return numbers;
}

} // namespace readme
