#include "readme/committed.hpp"

#include "readme/columns.hpp"
#include "readme/scanner.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>

namespace readme {

namespace {

/// The unit that a column's title gives to its cells.
void give_unit(const std::string& title, Number& number) {
  const auto says = [&](const char* word) { return title.find(word) != title.npos; };
  if (number.unit != Unit::none || says("steps /"))
    return;
  const bool micro = says("µs"), milli = says("ms per"), nano = says("ns per");
  if (says("bytes"))
    number.unit = Unit::bytes;
  else if (says(", %") || says("percent"))
    number.unit = Unit::percent;
  else if (micro || milli || nano || title.ends_with(" s") || says("CPU s") || says("cpu_s")) {
    number.unit = Unit::seconds;
    number.scale = micro ? 1e-6 : milli ? 1e-3 : nano ? 1e-9 : 1;
  }
}

/// A cell of a CSV whose field says who ran it or what it is called holds no number.
bool is_measured(const std::string& title) {
  constexpr std::array names{"key",      "case_digest", "answer_sources", "commit",
                             "compiler", "flags",       "machine",        "started_utc"};
  return std::ranges::find(names, title) == names.end();
}

/// A value with its bar may also be two columns of a row.
bool has_in(const std::vector<Number>& line, const Number& claimed) {
  const auto held = [&](const Number& one) {
    return std::ranges::any_of(line, [&](const Number& is) { return rounds_to(is, one); });
  };
  if (!claimed.bar || held(claimed))
    return held(claimed);
  Number value = claimed, bar = claimed;
  value.bar = bar.bar = std::nullopt;
  bar.value = *claimed.bar;
  bar.step = claimed.bar_step;
  bar.has_sign = false;
  return held(value) && held(bar);
}

/// What one printed number also says: its bar, and the ratio that a difference such as +38 % is (1.38).
void add_with_what_it_says(Number number, std::vector<Number>& line) {
  line.push_back(number);
  if (number.bar) {
    Number bar = number;
    bar.value = *number.bar;
    bar.bar = std::nullopt;
    bar.has_sign = false;
    line.push_back(bar);
  }
  if (number.has_sign && number.unit == Unit::percent) {
    number.value = 1 + number.value / 100;
    number.unit = Unit::none;
    number.bar = std::nullopt;
    line.push_back(number);
  }
}

} // namespace

bool Committed::has(const Number& claimed) const {
  return std::ranges::any_of(lines, [&](const auto& line) { return has_in(line, claimed); });
}

bool Committed::has_in_one_line(const std::vector<Number>& claimed) const {
  return std::ranges::any_of(lines, [&](const auto& line) {
    return std::ranges::all_of(claimed, [&](const Number& one) { return has_in(line, one); });
  });
}

Committed read_committed(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in)
    throw std::runtime_error("no results in " + file.string());
  Committed committed;
  const bool is_csv = file.extension() == ".csv";
  std::vector<std::string> titles;
  for (std::string line; std::getline(in, line) && line != "## Runs" && line != "## Where the numbers come from";) {
    if (is_csv && line.starts_with('#'))
      continue;
    if (!is_csv && !line.starts_with('|')) {
      titles.clear();
      std::vector<Number>& numbers = committed.lines.emplace_back();
      for (const Number& number : numbers_in(line))
        add_with_what_it_says(number, numbers);
      continue;
    }
    const auto cells = cells_of(line, is_csv ? ',' : '|');
    if (titles.empty()) {
      titles = cells;
      continue;
    }
    std::vector<Number>& row = committed.lines.emplace_back();
    for (std::size_t i = 0; i < std::min(cells.size(), titles.size()); ++i)
      if (!is_csv || is_measured(titles[i]))
        for (const std::string& part : cells_of(cells[i], '='))
          for (Number number : numbers_in(part)) {
            give_unit(titles[i], number);
            add_with_what_it_says(number, row);
          }
  }
  return committed;
}

} // namespace readme
