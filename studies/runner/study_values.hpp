#pragma once

#include "pfv/problem/toml_input.hpp"
#include "studies/runner/budget.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace studies {

/// Values as they occur in a study.toml. All throw pfv::InputError led by file:line, quoting what is there and saying
/// what is allowed; `name` or `key` is what the message calls it.

/// Calls `read(node)` when `table` has this key.
template <class Read>
void if_present(const toml::table& table, std::string_view key, Read read) {
  if (const toml::node* node = table.get(key))
    read(*node);
}

/// A finite number larger than zero.
double as_positive(const toml::node& node, std::string_view name);

/// A list with at least one entry.
const toml::array& as_list(const toml::node& node, std::string_view name);

/// Positive numbers from coarse to fine, each smaller than the one before.
std::vector<double> as_mesh_sizes(const toml::node& node, std::string_view name);

/// A text out of `valid`, or a list of such.
std::string as_one_of(const toml::node& node, std::string_view key, const std::vector<std::string>& valid);
std::vector<std::string> as_some_of(const toml::node& node, std::string_view key,
                                    const std::vector<std::string>& valid);

/// A table with any of Budget's keys; what it does not name is that of `otherwise`.
Budget as_budget(const toml::node& node, const Budget& otherwise);

} // namespace studies
