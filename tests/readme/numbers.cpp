#include "readme/numbers.hpp"

#include "readme/scanner.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace readme {

namespace {

struct UnitName {
  std::string_view name;
  Unit unit;
  double scale;
};

constexpr std::array unit_names{UnitName{"%", Unit::percent, 1},
                                UnitName{"CPU seconds", Unit::seconds, 1},
                                UnitName{"CPU minutes", Unit::seconds, 60},
                                UnitName{"seconds", Unit::seconds, 1},
                                UnitName{"minutes", Unit::seconds, 60},
                                UnitName{"CPU s", Unit::seconds, 1},
                                UnitName{"kB", Unit::bytes, 1e3},
                                UnitName{"MB", Unit::bytes, 1e6},
                                UnitName{"GB", Unit::bytes, 1e9},
                                UnitName{"ms", Unit::seconds, 1e-3},
                                UnitName{"µs", Unit::seconds, 1e-6},
                                UnitName{"ns", Unit::seconds, 1e-9},
                                UnitName{"s", Unit::seconds, 1}};

constexpr std::array joints{", ", " and ", " to ", " or ", " / ", "-", "/", " of "};
constexpr std::array places{"Table ", "table ", "figure ", "Figure ", "section ", "Section ", "figures "};

/// One of the last digit that counts.
double last_digit(const std::string& figure) {
  const auto power = figure.find('e');
  const std::string mantissa = figure.substr(0, power);
  const double scale = power == figure.npos ? 1 : std::pow(10, std::stod(figure.substr(power + 1)));
  if (const auto point = mantissa.find('.'); point != mantissa.npos)
    return scale * std::pow(10, -static_cast<double>(mantissa.size() - point - 1));
  if (power != figure.npos)
    return scale;
  const auto last = mantissa.find_last_not_of('0');
  const auto digits = std::max<std::size_t>(last == mantissa.npos ? 0 : last + 1, 2);
  return mantissa.size() <= digits ? 1 : std::pow(10, static_cast<double>(mantissa.size() - digits));
}

void read_unit(Scanner& scan, Number& number) {
  const std::size_t start = scan.place();
  scan.take(" ");
  for (const UnitName& is : unit_names)
    if (scan.take(is.name)) {
      if (is.unit != Unit::percent && letter(scan.now())) {
        scan.to(scan.place() - is.name.size());
        continue;
      }
      number.unit = is.unit;
      number.scale = is.scale;
      return;
    }
  scan.to(start);
}

void scale(Number& number, const std::string& exponent) {
  if (exponent.empty())
    return;
  const double by = std::pow(10, std::stod(exponent.substr(1)));
  number.value *= by;
  number.step *= by;
  *number.bar *= by;
  number.bar_step *= by;
}

/// 1.2e-3 s, (8.50 ± 0.06)e-4, +37 % ± 0.8 %, from its first digit on.
Number read_number(Scanner& scan, bool negative) {
  Number number;
  const std::string figure = scan.figure();
  number.value = std::stod(figure) * (negative ? -1 : 1);
  number.step = last_digit(figure);
  read_unit(scan, number);
  const auto end = scan.place();
  const std::string bar = scan.take(" ± ") ? scan.figure() : "";
  if (bar.empty()) {
    scan.to(end);
    return number;
  }
  number.bar = std::stod(bar);
  number.bar_step = last_digit(bar);
  if (scan.take(")"))
    scale(number, scan.exponent());
  read_unit(scan, number);
  return number;
}

/// A + or - before the digit at `place`, unless it is a dash or an operator between two things.
bool is_sign(std::string_view text, std::size_t place) {
  if (place == 0 || (text[place - 1] != '+' && text[place - 1] != '-'))
    return false;
  const char before = place < 2 ? ' ' : text[place - 2];
  return !letter(before) && !digit(before) && before != ')';
}

/// Part of a word or of a power, or the number of a table or a figure.
bool is_name(const Scanner& scan, std::string_view text) {
  const char before = scan.before();
  return letter(before) || before == '^' || before == '.' || before == '#' ||
         (before == '-' && scan.place() >= 2 && letter(text[scan.place() - 2])) ||
         std::ranges::any_of(places, [&](std::string_view is) { return scan.after(is); });
}

/// What may not hold a number, blanked.
std::string prose_of(std::string_view line) {
  std::string text(line);
  const auto blank = [&](std::string_view from, std::string_view to) {
    for (auto at = text.find(from); at != text.npos; at = text.find(from, at)) {
      const auto end = text.find(to, at + from.size());
      const auto length = end == text.npos ? from.size() : end + to.size() - at;
      text.replace(at, length, length, '_');
      at += length;
    }
  };
  blank("`", "`");
  blank("](", ")");
  return text;
}

} // namespace

std::vector<Number> numbers_in(std::string_view line) {
  const std::string text = prose_of(line);
  std::vector<Number> found;
  std::vector<std::string> joints_before; // to the number before it; "" where there is none
  std::size_t end_of_last = text.npos;
  for (Scanner scan(text); !scan.done();) {
    if (!digit(scan.now())) {
      scan.to(scan.place() + 1);
      continue;
    }
    const bool signed_here = is_sign(text, scan.place());
    const std::size_t start = scan.place() - (signed_here ? 1 : 0);
    const bool named = is_name(scan, text);
    Number number = read_number(scan, signed_here && scan.before() == '-');
    number.has_sign = signed_here;
    number.text = std::string(scan.since(start));
    if (named || scan.now() == '^' || (letter(scan.now()))) {
      while (letter(scan.now()) || digit(scan.now()))
        scan.to(scan.place() + 1);
      end_of_last = text.npos;
      continue;
    }
    const std::string between = end_of_last == text.npos ? "" : text.substr(end_of_last, start - end_of_last);
    joints_before.push_back(std::ranges::find(joints, between) == joints.end() ? "" : between);
    end_of_last = scan.place();
    found.push_back(number);
  }
  // 16, 13 and 12 %: a list has the unit of its last; what only a comma parts from it is no list.
  bool in_list = false;
  for (std::size_t i = found.size(); i-- > 1;) {
    in_list = found[i - 1].unit == Unit::none && !joints_before[i].empty() && (in_list || joints_before[i] != ", ");
    if (in_list) {
      found[i - 1].unit = found[i].unit;
      found[i - 1].scale = found[i].scale;
    }
  }
  return found;
}

bool rounds_to(const Number& committed, const Number& claimed) {
  const auto rounds = [](double is, double said, double step) {
    return std::abs(is - said) <= 0.5 * step * (1 + 1e-9);
  };
  if (committed.unit != claimed.unit && claimed.unit != Unit::none &&
      !(committed.unit == Unit::none && claimed.unit != Unit::percent))
    return false;
  const bool same_unit = claimed.unit != Unit::none && committed.unit == claimed.unit;
  const double to_claimed = same_unit ? committed.scale / claimed.scale : 1;
  const double value = committed.value * to_claimed;
  if (!(claimed.has_sign ? rounds(value, claimed.value, claimed.step)
                         : rounds(std::abs(value), std::abs(claimed.value), claimed.step)))
    return false;
  return !claimed.bar || (committed.bar && rounds(*committed.bar * to_claimed, *claimed.bar, claimed.bar_step));
}

} // namespace readme
