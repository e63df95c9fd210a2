#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace studies {

/// Replaces the file at once: whoever reads it sees the old text or the new one, never half of it.
/// Throws std::system_error when it cannot be written.
void write_file(const std::filesystem::path& file, std::string_view text);

/// 32 hexadecimal digits of a text.
std::string text_digest(std::string_view text);

} // namespace studies
