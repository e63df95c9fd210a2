#pragma once

#include "pfv/problem/error.hpp"
#include "pfv/problem/vec3.hpp"

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <toml++/toml.h>

namespace pfv {

/// Reads a TOML file. Throws InputError (file, line, reason) when it cannot be read or is not TOML. Every node of the
/// result knows its file and line, which the functions below lead their messages with.
toml::table read_toml(const std::filesystem::path& file);

/// Throws InputError "file:line: message".
[[noreturn]] void fail_at(const toml::node& node, std::string_view message);

/// The node as it would be written, shortened when long, for messages.
std::string quote(const toml::node& node);

/// Throws InputError on the first key of `table` that is not in `keys`, naming those. `place` reads like "[fluid]".
void allow_keys(const toml::table& table, std::string_view place, std::initializer_list<std::string_view> keys);

/// The node of a key that must be there.
const toml::node& required(const toml::table& table, std::string_view place, std::string_view key);

/// The node as a value of one kind; `name` is what the message calls it.
const toml::table& as_table(const toml::node& node, std::string_view name);
std::string as_text(const toml::node& node, std::string_view name);
double as_number(const toml::node& node, std::string_view name); // an integer will do
std::int64_t as_integer(const toml::node& node, std::string_view name);
Vec3 as_vector(const toml::node& node, std::string_view name);

/// Runs `read` and leads the message of any InputError from it with the node's file and line.
template <typename Read>
auto located(const toml::node& node, Read read) {
  try {
    return read();
  } catch (const InputError& error) {
    fail_at(node, error.what());
  }
}

} // namespace pfv
