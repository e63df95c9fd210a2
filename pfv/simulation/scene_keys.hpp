#pragma once

#include <limits>
#include <string_view>
#include <toml++/toml.h>

namespace pfv {

// What tables of a scene file hold. Each throws InputError (file, line, value, what is allowed).

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

/// The number of a key, or what it is when left out; it must lie in [least, most], and not be zero when `positive`.
double number(const toml::table& table, std::string_view key, double otherwise, double least, double most = unbounded,
              bool positive = false);

/// The same of a number that must be above 0.
double positive(const toml::table& table, std::string_view key, double otherwise, double most = unbounded);

/// The table of this name, or null.
const toml::table* part(const toml::table& root, std::string_view name);

} // namespace pfv
