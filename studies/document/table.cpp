#include "studies/document/table.hpp"

#include <algorithm>

namespace studies {

namespace {

// Characters as a terminal counts them: UTF-8 continuation bytes take no room.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t to, bool right) {
  const std::string blanks(to - std::min(to, width(text)), ' ');
  return right ? blanks + text : text + blanks;
}

std::string trimmed(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

std::string markdown_cell(const std::string& text) {
  std::string cell;
  for (const char c : text) {
    if (c == '|')
      cell += "\\|";
    else
      cell += c == '\n' ? ' ' : c;
  }
  return cell;
}

} // namespace

std::string to_plain(const Table& table) {
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    widths.push_back(width(table.columns[i].title));
    for (const auto& row : table.rows)
      widths[i] = std::max(widths[i], width(row[i]));
  }
  std::string titles;
  std::string rule;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    titles += padded(table.columns[i].title, widths[i], table.columns[i].numbers) + "  ";
    rule += std::string(widths[i], '-') + "  ";
  }
  std::string text = trimmed(titles) + '\n' + trimmed(rule) + '\n';
  for (const auto& row : table.rows) {
    std::string line;
    for (std::size_t i = 0; i < widths.size(); ++i)
      line += padded(row[i], widths[i], table.columns[i].numbers) + "  ";
    text += trimmed(line) + '\n';
  }
  return text;
}

std::string to_markdown(const Table& table) {
  std::string titles = "|";
  std::string rule = "|";
  for (const Table::Column& column : table.columns) {
    titles.append(" ").append(markdown_cell(column.title)).append(" |");
    rule += column.numbers ? " ---: |" : " --- |";
  }
  std::string text = titles + '\n' + rule + '\n';
  for (const auto& row : table.rows) {
    text += '|';
    for (const std::string& cell : row)
      text.append(" ").append(markdown_cell(cell)).append(" |");
    text += '\n';
  }
  return text;
}

} // namespace studies
