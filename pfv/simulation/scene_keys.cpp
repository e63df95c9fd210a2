#include "pfv/simulation/scene_keys.hpp"

#include "pfv/problem/text.hpp"
#include "pfv/problem/toml_input.hpp"

#include <cmath>
#include <fmt/format.h>

namespace pfv {

double number(const toml::table& table, std::string_view key, double otherwise, double least, double most,
              bool positive) {
  const toml::node* node = table.get(key);
  if (!node)
    return otherwise;
  const double value = as_number(*node, key);
  if (!(std::isfinite(value) && value >= least && value <= most && (value > 0 || !positive)))
    fail_at(*node, fmt::format("{} \"{}\" must be {}{}", key, shortest(value),
                               positive ? "above 0" : fmt::format("at least {}", shortest(least)),
                               most < unbounded ? fmt::format(" and at most {}", shortest(most)) : ""));
  return value;
}

double positive(const toml::table& table, std::string_view key, double otherwise, double most) {
  return number(table, key, otherwise, 0, most, true);
}

const toml::table* part(const toml::table& root, std::string_view name) {
  const toml::node* node = root.get(name);
  return node ? &as_table(*node, name) : nullptr;
}

} // namespace pfv
