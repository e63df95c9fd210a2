#include "readme/claims.hpp"

#include "readme/derive.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace readme {

namespace {

bool same(const Number& a, const Number& b) {
  return a.value == b.value && a.bar == b.bar;
}

bool among(const Number& number, const std::vector<Number>& some) {
  return std::ranges::any_of(some, [&](const Number& is) { return same(number, is); });
}

/// Numbers that a block declares, and what is wrong with how it does.
struct Declared {
  std::vector<Number> numbers;
  std::vector<std::string> problems;
};

Declared declared_by(const Block& block, const Sources& sources) {
  Declared declared;
  for (const std::string& line : block.says) {
    if (line.starts_with("given ")) {
      for (const Number& number : numbers_in(line.substr(6)))
        declared.numbers.push_back(number);
    } else if (const auto equals = line.find(" = "); equals != line.npos) {
      const auto claimed = numbers_in(line.substr(0, equals));
      try {
        Number derived = claimed.at(0);
        const std::string value = line.substr(equals + 3);
        const auto bar = value.find(" ± ");
        derived.value = derive(value.substr(0, bar), sources);
        if (derived.bar && bar == value.npos)
          throw std::runtime_error("what its bar is does not stand there");
        if (derived.bar)
          derived.bar = derive(value.substr(bar + std::string_view(" ± ").size()), sources);
        if (!rounds_to(derived, claimed[0]))
          throw std::runtime_error("it is " + std::to_string(derived.value));
        declared.numbers.push_back(claimed[0]);
      } catch (const std::exception& error) {
        declared.problems.push_back(line + ": " + error.what());
      }
    } else if (!line.starts_with("from ") && line != "by rows")
      declared.problems.push_back(line + ": not understood; allowed are given, ... = ..., from, by rows");
  }
  return declared;
}

} // namespace

std::vector<Block> blocks_of(const std::filesystem::path& readme) {
  std::ifstream in(readme);
  if (!in)
    throw std::runtime_error("no " + readme.string());
  std::vector<Block> blocks;
  std::string heading;
  bool in_code = false, in_comment = false, open = false;
  std::size_t at = 0;
  for (std::string line; std::getline(in, line);) {
    ++at;
    if (line.find("```") != line.npos)
      in_code = !in_code;
    else if (in_code)
      continue;
    else if (line.starts_with('#'))
      heading = line.substr(line.find_first_not_of("# "));
    else if (const auto comment = line.find("<!--"); in_comment || comment != line.npos) {
      const auto first = line.find_first_not_of(" ", in_comment ? 0 : comment + 4);
      const auto end = line.find("-->");
      const auto last = end == 0 ? line.npos : line.find_last_not_of(" ", end == line.npos ? end : end - 1);
      if (open && first != line.npos && last != line.npos && first <= last && first != end)
        blocks.back().says.push_back(line.substr(first, last + 1 - first));
      in_comment = end == line.npos;
      continue;
    } else if (!line.empty()) {
      if (!open)
        blocks.push_back({readme, at, heading, {}, {}});
      blocks.back().text.push_back(line);
      open = true;
      continue;
    }
    open = false;
  }
  return blocks;
}

std::set<std::string> sources_of(const Block& block) {
  std::set<std::string> sources;
  for (const std::string& line : block.says)
    if (line.starts_with("from "))
      sources.insert(line.substr(5));
  for (const std::string& line : block.text)
    for (auto at = line.find("]("); at != line.npos; at = line.find("](", at + 2)) {
      const std::string target = line.substr(at + 2, line.find(')', at) - at - 2);
      if (target.ends_with(".csv") || target.ends_with("results/report.md"))
        sources.insert(target);
    }
  return sources;
}

Held hold(const Block& block, const std::vector<Committed>& results) {
  const auto is_known = [&](const Number& number) {
    return std::ranges::any_of(results, [&](const Committed& is) { return is.has(number); });
  };
  const Declared declared = declared_by(block, {is_known, block.file.parent_path()});
  Held held;
  held.problems = declared.problems;
  const bool by_rows = std::ranges::find(block.says, "by rows") != block.says.end();
  // A sentence goes on in the next line, a row of a table does not.
  std::vector<std::string> parts;
  for (const std::string& line : block.text)
    if (line.starts_with('|') || parts.empty())
      parts.push_back(line);
    else
      parts.back().append(" ").append(line.substr(line.find_first_not_of(' ')));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::vector<Number> open;
    for (const Number& number : numbers_in(parts[i]))
      if (among(number, declared.numbers))
        ++held.declared;
      else
        open.push_back(number);
    if (by_rows && i >= 2 &&
        !std::ranges::any_of(results, [&](const Committed& is) { return is.has_in_one_line(open); }))
      held.problems.push_back("no line of the results has all of " + parts[i]);
    for (const Number& number : open)
      if (is_known(number))
        held.found.push_back(number);
      else
        held.problems.push_back(number.text + " is not in the results");
  }
  return held;
}

} // namespace readme
