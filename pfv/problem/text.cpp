#include "pfv/problem/text.hpp"

#include "pfv/problem/error.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <system_error>

namespace pfv {

std::string read_text(const std::filesystem::path& file) {
  std::ostringstream text;
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  // A folder opens like a file and fails only when it is read.
  if (in && in.peek() != std::ifstream::traits_type::eof())
    text << in.rdbuf();
  if (!in.is_open() || in.bad() || text.bad())
    throw InputError(fmt::format("{}: cannot be read: {}", file.string(), std::generic_category().message(errno)));
  return std::move(text).str();
}

std::optional<double> to_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-"))
    text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    return std::nullopt;
  return value;
}

std::string shortest(double value) {
  return fmt::format("{}", value == 0 ? 0.0 : value);
}

std::string shortest(const Vec3& value, std::string_view separator) {
  return fmt::format("{}{}{}{}{}", shortest(value.x()), separator, shortest(value.y()), separator, shortest(value.z()));
}

std::string shortened(std::string_view text) {
  return text.size() <= 60 ? std::string(text) : std::string(text.substr(0, 57)) + "...";
}

std::string printable(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return text;
}

} // namespace pfv
