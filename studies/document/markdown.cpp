#include "studies/document/markdown.hpp"

#include <fmt/format.h>

#include <span>

namespace studies {

namespace {

std::string markdown_of(std::span<const Block> blocks);

std::string markdown_of(const Heading& heading) {
  return fmt::format("{} {}\n", std::string(static_cast<std::size_t>(heading.level), '#'), heading.text);
}

std::string markdown_of(const Paragraph& paragraph) {
  return paragraph.text + '\n';
}

std::string markdown_of(const List& list) {
  std::string text;
  for (const std::string& item : list.items)
    text += fmt::format("- {}\n", item);
  return text;
}

std::string markdown_of(const Table& table) {
  return to_markdown(table);
}

std::string markdown_of(const Code& code) {
  return fmt::format("```{}\n{}```\n", code.language, code.text);
}

std::string markdown_of(const Figure& figure) {
  return figure.file.empty() ? "" : fmt::format("![{}]({})\n", figure.caption, figure.file);
}

std::string markdown_of(const Plot&) {
  return "";
}

std::string markdown_of(const Details& details) {
  return markdown_of(details.heading) + '\n' + markdown_of(details.blocks);
}

std::string markdown_of(std::span<const Block> blocks) {
  std::string text;
  for (const Block& block : blocks) {
    const std::string one = std::visit([](const auto& is) { return markdown_of(is); }, block.is);
    if (!one.empty())
      text += (text.empty() ? "" : "\n") + one;
  }
  return text;
}

/// A | that is escaped is part of a cell.
std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells;
  std::string cell;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] == '\\' && i + 1 < line.size() && line[i + 1] == '|')
      cell += line[++i];
    else if (line[i] != '|')
      cell += line[i];
    else {
      const std::size_t first = cell.starts_with(' ') ? 1 : 0;
      cells.push_back(cell.size() > 1 && cell.ends_with(' ') ? cell.substr(first, cell.size() - 1 - first) : "");
      cell.clear();
    }
  }
  return cells;
}

Table table_of(std::span<const std::string_view> lines) {
  Table table;
  for (const std::string& title : cells_of(lines[0]))
    table.columns.push_back({title});
  const auto rules = lines.size() > 1 ? cells_of(lines[1]) : std::vector<std::string>{};
  for (std::size_t i = 0; i < rules.size() && i < table.columns.size(); ++i)
    table.columns[i].numbers = rules[i].ends_with(':');
  for (const std::string_view line : lines.subspan(std::min<std::size_t>(2, lines.size()))) {
    table.rows.push_back(cells_of(line));
    table.rows.back().resize(table.columns.size());
  }
  return table;
}

Block block_of(std::span<const std::string_view> lines) {
  const std::string_view first = lines[0];
  if (first.starts_with("```")) {
    Code code{std::string(first.substr(3)), ""};
    for (const std::string_view line : lines.subspan(1, lines.size() - 2))
      code.text.append(line).append("\n");
    return {code};
  }
  if (first.starts_with('|'))
    return {table_of(lines)};
  if (first.starts_with('#') && lines.size() == 1) {
    const auto level = first.find_first_not_of('#');
    return {Heading{std::string(first.substr(std::min(level + 1, first.size()))), static_cast<int>(level)}};
  }
  if (first.starts_with("- ")) {
    List list;
    for (const std::string_view line : lines) {
      if (line.starts_with("- "))
        list.items.emplace_back(line.substr(2));
      else
        list.items.back().append("\n").append(line);
    }
    return {list};
  }
  if (const auto middle = first.find("]("); first.starts_with("![") && first.ends_with(')') && middle != first.npos)
    return {Figure{std::string(first.substr(2, middle - 2)),
                   std::string(first.substr(middle + 2, first.size() - middle - 3))}};
  std::string text;
  for (const std::string_view line : lines)
    text.append(text.empty() ? "" : "\n").append(line);
  return {Paragraph{text}};
}

} // namespace

std::string to_markdown(const Document& document) {
  return markdown_of(Heading{document.title, 1}) + '\n' + markdown_of(document.blocks);
}

Document from_markdown(std::string_view text) {
  Document document;
  std::vector<std::string_view> lines;
  const auto end_block = [&] {
    if (lines.empty())
      return;
    if (document.title.empty() && lines[0].starts_with("# "))
      document.title = lines[0].substr(2);
    else
      document.blocks.push_back(block_of(lines));
    lines.clear();
  };
  bool in_comment = false;
  while (!text.empty()) {
    const auto length = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, length);
    text.remove_prefix(std::min(length + 1, text.size()));
    if (const bool in_code = !lines.empty() && lines[0].starts_with("```"); in_code || line.starts_with("```")) {
      if (!in_code)
        end_block();
      lines.push_back(line);
      if (in_code && line == "```")
        end_block();
      continue;
    }
    in_comment = in_comment || line.substr(std::min(line.find_first_not_of(' '), line.size())).starts_with("<!--");
    if (in_comment) {
      in_comment = line.find("-->") == line.npos;
      continue;
    }
    if (line.empty() || line.starts_with('#'))
      end_block();
    if (!line.empty())
      lines.push_back(line);
    if (line.starts_with('#'))
      end_block();
  }
  if (!lines.empty() && lines[0].starts_with("```"))
    lines.push_back("```"); // was not closed
  end_block();
  return document;
}

} // namespace studies
