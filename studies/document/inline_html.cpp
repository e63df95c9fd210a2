#include "studies/document/inline_html.hpp"

#include <fmt/format.h>

#include <cctype>

namespace studies {

namespace {

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || (c & 0x80) != 0;
}

bool may_link(std::string_view target) {
  const auto colon = target.find(':');
  return target.starts_with("https:") || target.starts_with("http:") ||
         (colon == std::string_view::npos && !target.empty());
}

/// Where the mark that opens `text` is closed: something is between, without a blank at either end.
std::size_t closing(std::string_view text, std::string_view mark) {
  if (text.size() <= mark.size() || text[mark.size()] == ' ' || text[mark.size()] == mark[0])
    return text.npos;
  auto at = text.find(mark, mark.size());
  while (at != text.npos && text[at - 1] == ' ')
    at = text.find(mark, at + 1);
  return at;
}

} // namespace

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
    case '<':
      html += "&lt;";
      break;
    case '>':
      html += "&gt;";
      break;
    case '&':
      html += "&amp;";
      break;
    case '"':
      html += "&quot;";
      break;
    default:
      html += c;
    }
  }
  return html;
}

std::string inline_html(std::string_view text) {
  std::string html;
  for (std::size_t i = 0; i < text.size();) {
    const std::string_view rest = text.substr(i);
    if (rest[0] == '`') {
      if (const auto end = rest.find('`', 1); end != rest.npos && end > 1) {
        html += fmt::format("<code>{}</code>", escaped(rest.substr(1, end - 1)));
        i += end + 1;
        continue;
      }
    }
    if (rest[0] == '*' && (i == 0 || !is_word(text[i - 1]))) {
      const bool strong = rest.starts_with("**");
      const std::string_view mark = strong ? "**" : "*";
      if (const auto end = closing(rest, mark); end != rest.npos) {
        const char* tag = strong ? "strong" : "em";
        html += fmt::format("<{0}>{1}</{0}>", tag, inline_html(rest.substr(mark.size(), end - mark.size())));
        i += end + mark.size();
        continue;
      }
    }
    if (rest[0] == '[') {
      const auto middle = rest.find("](");
      const auto end = middle == rest.npos ? rest.npos : rest.find(')', middle);
      if (end != rest.npos && rest.find('[', 1) > middle && may_link(rest.substr(middle + 2, end - middle - 2))) {
        html += fmt::format("<a href=\"{}\">{}</a>", escaped(rest.substr(middle + 2, end - middle - 2)),
                            inline_html(rest.substr(1, middle - 1)));
        i += end + 1;
        continue;
      }
    }
    html += escaped(rest.substr(0, 1));
    ++i;
  }
  return html;
}

} // namespace studies
