#include "pfv/problem/packing_file/text_lines.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace pfv {
namespace {

constexpr std::string_view blanks = " \t\r\f\v";

} // namespace

Fields split_at_blanks(std::string_view text) {
  Fields fields;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    if (text.empty())
      return fields;
    const auto end = std::min(text.find_first_of(blanks), text.size());
    fields.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
}

Fields split_at_commas(std::string_view text) {
  Fields fields;
  while (true) {
    const auto end = text.find(',');
    std::string_view field = text.substr(0, end);
    field.remove_prefix(std::min(field.find_first_not_of(blanks), field.size()));
    fields.push_back(field.substr(0, field.find_last_not_of(blanks) + 1));
    if (end == std::string_view::npos)
      return fields;
    text.remove_prefix(end + 1);
  }
}

bool TextLines::next() {
  if (rest_.empty())
    return false;
  const auto end = std::min(rest_.find('\n'), rest_.size());
  line_ = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  ++number_;
  return true;
}

double TextLines::length(std::string_view name, std::string_view field) const {
  const auto value = to_number(field);
  if (!value)
    fail(fmt::format("{} \"{}\" must be a number (m)", name, shortened(field)));
  return *value;
}

std::size_t TextLines::count(std::string_view name, std::string_view field) const {
  const auto value = to_number(field);
  if (!value || !(*value >= 0 && *value <= 1e9) || *value != std::floor(*value))
    fail(fmt::format("{} \"{}\" must be a whole number, at most 1e9", name, shortened(field)));
  return static_cast<std::size_t>(*value);
}

void TextLines::fail(std::string_view message) const {
  throw InputError(fmt::format("{}:{}: {}", file_, std::max(number_, 1), message));
}

} // namespace pfv
