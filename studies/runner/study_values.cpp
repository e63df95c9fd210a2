#include "studies/runner/study_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace studies {

using pfv::fail_at;

double as_positive(const toml::node& node, std::string_view name) {
  const double value = pfv::as_number(node, name);
  if (!(value > 0) || !std::isfinite(value))
    fail_at(node, fmt::format("{} \"{}\" must be larger than zero", name, pfv::quote(node)));
  return value;
}

const toml::array& as_list(const toml::node& node, std::string_view name) {
  const toml::array* list = node.as_array();
  if (!list || list->empty())
    fail_at(node, fmt::format("{} \"{}\" must be a list with at least one entry", name, pfv::quote(node)));
  return *list;
}

std::vector<double> as_mesh_sizes(const toml::node& node, std::string_view name) {
  std::vector<double> sizes;
  for (const toml::node& size : as_list(node, name))
    sizes.push_back(as_positive(size, name));
  if (!std::ranges::is_sorted(sizes, std::ranges::greater_equal{}) || std::ranges::adjacent_find(sizes) != sizes.end())
    fail_at(node, fmt::format("{} \"{}\" must go from coarse to fine, each smaller than the one before", name,
                              pfv::quote(node)));
  return sizes;
}

std::string as_one_of(const toml::node& node, std::string_view key, const std::vector<std::string>& valid) {
  const std::string name = pfv::as_text(node, key);
  if (std::ranges::find(valid, name) == valid.end())
    fail_at(node, fmt::format("{} \"{}\" must be one of {}", key, name, fmt::join(valid, ", ")));
  return name;
}

std::vector<std::string> as_some_of(const toml::node& node, std::string_view key,
                                    const std::vector<std::string>& valid) {
  std::vector<std::string> names;
  for (const toml::node& entry : as_list(node, key))
    names.push_back(as_one_of(entry, key, valid));
  return names;
}

Budget as_budget(const toml::node& node, const Budget& otherwise) {
  const toml::table& table = pfv::as_table(node, "budget");
  pfv::allow_keys(table, "budget", {"cpu_seconds", "memory_bytes", "wall_seconds"});
  Budget budget = otherwise;
  if_present(table, "cpu_seconds", [&](auto& value) { budget.cpu_seconds = as_positive(value, "cpu_seconds"); });
  if_present(table, "memory_bytes", [&](auto& value) { budget.memory_bytes = as_positive(value, "memory_bytes"); });
  if_present(table, "wall_seconds", [&](auto& value) { budget.wall_seconds = as_positive(value, "wall_seconds"); });
  return budget;
}

} // namespace studies
