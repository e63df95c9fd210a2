#pragma once

#include "pfv/problem/vec3.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace pfv {

/// The whole file. Throws InputError with the system's reason when it cannot be read.
std::string read_text(const std::filesystem::path& file);

/// The whole of `text` as a number (inf and nan included), or nothing.
std::optional<double> to_number(std::string_view text);

/// The fewest digits that read back to the same double; the two zeros, which compare equal, both read "0".
std::string shortest(double value);
std::string shortest(const Vec3& value, std::string_view separator = " ");

/// Its first 60 characters, for quotes in messages.
std::string shortened(std::string_view text);

/// The text in one line: control characters replaced by question marks.
std::string printable(std::string text);

} // namespace pfv
