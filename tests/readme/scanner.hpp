#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

namespace readme {

inline bool digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Of a word; all that is not ASCII counts.
inline bool letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_' || (c & 0x80) != 0;
}

/// Reads from the left what it is asked for.
class Scanner {
public:
  explicit Scanner(std::string_view text) : text_(text) {}

  bool done() const { return at_ >= text_.size(); }
  char now() const { return done() ? '\0' : text_[at_]; }
  char before() const { return at_ == 0 ? '\0' : text_[at_ - 1]; }
  std::size_t place() const { return at_; }
  void to(std::size_t place) { at_ = std::min(place, text_.size()); }
  std::string_view rest() const { return text_.substr(at_); }
  std::string_view since(std::size_t place) const { return text_.substr(place, at_ - place); }
  bool after(std::string_view word) const { return text_.substr(0, at_).ends_with(word); }
  bool take(std::string_view word) {
    const bool here = rest().starts_with(word);
    at_ += here ? word.size() : 0;
    return here;
  }

  std::string digits() {
    std::string taken;
    for (; digit(now()); ++at_)
      taken += text_[at_];
    return taken;
  }

  /// e-4, when a number's exponent stands here.
  std::string exponent() {
    const std::size_t start = at_;
    std::string taken = "e";
    if (!take("e"))
      return "";
    if (now() == '-' || now() == '+')
      taken += text_[at_++];
    const std::string power = digits();
    if (power.empty() || letter(now())) {
      at_ = start;
      return "";
    }
    return taken + power;
  }

  /// 120 888, 0.5, 1e-3, without a sign; "" where there is none. Blanks between thousands are left out.
  std::string figure() {
    std::string taken = digits();
    if (taken.size() <= 3 && !taken.starts_with('0'))
      for (auto ahead = rest(); is_thousand(ahead); ahead = rest()) {
        ++at_;
        taken += digits();
      }
    if (!taken.empty() && now() == '.' && at_ + 1 < text_.size() && digit(text_[at_ + 1])) {
      ++at_;
      taken += '.' + digits();
    }
    return taken.empty() ? "" : taken + exponent();
  }

private:
  static bool is_thousand(std::string_view text) { // " 888", nothing of a number behind it
    return text.size() >= 4 && text[0] == ' ' && digit(text[1]) && digit(text[2]) && digit(text[3]) &&
           (text.size() == 4 || !(digit(text[4]) || text[4] == '.' || text[4] == '%'));
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

} // namespace readme
