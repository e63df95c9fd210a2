#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pfv {

using Fields = std::vector<std::string_view>;

/// The parts of `text` between blanks.
Fields split_at_blanks(std::string_view text);

/// The parts of `text` between commas, without the blanks around them; a part may be empty.
Fields split_at_commas(std::string_view text);

/// The lines of a text, one after the other, and what is said of one that is wrong.
class TextLines {
public:
  TextLines(std::string file, std::string_view text) : file_(std::move(file)), rest_(text) {}

  /// Goes to the next line; false when there is none.
  bool next();

  std::string_view line() const { return line_; }
  int number() const { return number_; } // from 1
  const std::string& file() const { return file_; }

  /// The field as a length. Throws InputError when it is no number; `name` is what the message calls it.
  double length(std::string_view name, std::string_view field) const;

  /// The field as the number of something, at most 1e9. Throws likewise.
  std::size_t count(std::string_view name, std::string_view field) const;

  /// Throws InputError "file:line: message".
  [[noreturn]] void fail(std::string_view message) const;

private:
  std::string file_;
  std::string_view rest_, line_;
  int number_ = 0;
};

} // namespace pfv
