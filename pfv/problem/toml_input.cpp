#include "pfv/problem/toml_input.hpp"

#include "pfv/problem/text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sstream>

namespace pfv {

namespace {

std::string place_of(const toml::source_region& source) {
  return fmt::format("{}:{}", source.path ? *source.path : "TOML", source.begin.line);
}

} // namespace

toml::table read_toml(const std::filesystem::path& file) {
  try {
    return toml::parse(read_text(file), file.string());
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}: not TOML: {}", place_of(error.source()), error.description()));
  }
}

void fail_at(const toml::node& node, std::string_view message) {
  throw InputError(fmt::format("{}: {}", place_of(node.source()), message));
}

std::string quote(const toml::node& node) {
  if (const auto* text = node.as_string())
    return text->get();
  if (const auto* number = node.as_floating_point()) {
    const std::string digits = shortest(number->get());
    return digits.find_first_not_of("-0123456789") == std::string::npos ? digits + ".0" : digits;
  }
  std::ostringstream out;
  node.visit([&](const auto& concrete) { out << concrete; });
  std::string text = std::move(out).str();
  std::ranges::replace(text, '\n', ' ');
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

void allow_keys(const toml::table& table, std::string_view place, std::initializer_list<std::string_view> keys) {
  for (const auto& [key, node] : table)
    if (std::ranges::find(keys, key.str()) == keys.end())
      throw InputError(fmt::format("{}: unknown key \"{}\" in {}; valid keys: {}", place_of(key.source()), key.str(),
                                   place, fmt::join(keys, ", ")));
}

const toml::node& required(const toml::table& table, std::string_view place, std::string_view key) {
  const toml::node* node = table.get(key);
  if (!node)
    fail_at(table, fmt::format("{} has no \"{}\"; it is needed", place, key));
  return *node;
}

const toml::table& as_table(const toml::node& node, std::string_view name) {
  if (const auto* table = node.as_table())
    return *table;
  fail_at(node, fmt::format("{} \"{}\" must be a table", name, quote(node)));
}

std::string as_text(const toml::node& node, std::string_view name) {
  if (const auto* text = node.as_string())
    return text->get();
  fail_at(node, fmt::format("{} \"{}\" must be a text in quotes", name, quote(node)));
}

double as_number(const toml::node& node, std::string_view name) {
  if (const auto* number = node.as_floating_point())
    return number->get();
  if (const auto* number = node.as_integer())
    return static_cast<double>(number->get());
  fail_at(node, fmt::format("{} \"{}\" must be a number", name, quote(node)));
}

std::int64_t as_integer(const toml::node& node, std::string_view name) {
  if (const auto* number = node.as_integer())
    return number->get();
  fail_at(node, fmt::format("{} \"{}\" must be a whole number", name, quote(node)));
}

Vec3 as_vector(const toml::node& node, std::string_view name) {
  const auto* array = node.as_array();
  if (!array || array->size() != 3)
    fail_at(node, fmt::format("{} \"{}\" must be three numbers [x, y, z]", name, quote(node)));
  return {as_number((*array)[0], name), as_number((*array)[1], name), as_number((*array)[2], name)};
}

} // namespace pfv
