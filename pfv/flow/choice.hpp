#pragma once

#include "pfv/problem/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace pfv {

/// The names of all alternatives of a variant, in its order. Each alternative has a static `name`.
template <typename Choice>
std::vector<std::string_view> names_of() {
  return []<std::size_t... i>(std::index_sequence<i...>) {
    return std::vector<std::string_view>{std::variant_alternative_t<i, Choice>::name...};
  }
  (std::make_index_sequence<std::variant_size_v<Choice>>{});
}

inline std::string list_of(const std::vector<std::string_view>& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

/// The alternative of that name with its default parameters. `what` is what the message calls it. Throws InputError
/// that names the valid ones.
template <typename Choice>
Choice choice_named(std::string_view what, std::string_view name) {
  Choice found;
  const bool known = [&]<std::size_t... i>(std::index_sequence<i...>) {
    return ((std::variant_alternative_t<i, Choice>::name == name && (found.template emplace<i>(), true)) || ...);
  }
  (std::make_index_sequence<std::variant_size_v<Choice>>{});
  if (!known)
    throw InputError(fmt::format("{} \"{}\" is not one of {}", what, name, list_of(names_of<Choice>())));
  return found;
}

/// The name of the alternative that is chosen.
template <typename Choice>
std::string_view name_of(const Choice& choice) {
  return std::visit([](const auto& chosen) { return std::string_view(chosen.name); }, choice);
}

} // namespace pfv
