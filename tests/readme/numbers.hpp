#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace readme {

/// What a number counts. One without a unit may be anything but a percentage.
enum class Unit { none, percent, seconds, bytes };

/// A number as it is printed, with the bar that stands behind it.
struct Number {
  std::string text;          // as printed
  double value = 0;          // in the unit it is printed with
  double step = 0;           // one of its last digit
  std::optional<double> bar; // of value ± bar
  double bar_step = 0;
  Unit unit = Unit::none;
  double scale = 1;      // of the unit: 1e-3 for ms
  bool has_sign = false; // printed with + or -
};

/// The numbers of a line of prose or of a table's row: 1.2e-3, 120 888, +37 %, (8.50 ± 0.06)e-4, 16, 13 and 12 % (all
/// three per cent). Not those that are part of a word (g200, 4a), of `code`, of a link's address, of a power (2^23),
/// nor those of a table, a figure or a section.
std::vector<Number> numbers_in(std::string_view line);

/// Whether `committed` rounds to `claimed` at the digits that are claimed, bar and all. What is claimed without a sign
/// may have either; a percentage is held by percentages only; zeros that end an integer do not count as digits from the
/// third on.
bool rounds_to(const Number& committed, const Number& claimed);

} // namespace readme
