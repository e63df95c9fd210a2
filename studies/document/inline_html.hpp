#pragma once

#include <string>
#include <string_view>

namespace studies {

/// A text with < > & " escaped, fit for HTML and for its attributes.
std::string escaped(std::string_view text);

/// Inline Markdown (*emphasis*, **strong**, `code`, [a link](to)) as HTML, everything else escaped. A mark without its
/// partner is itself. A link goes to a web address or to a file beside the page, anything else stays text.
std::string inline_html(std::string_view text);

} // namespace studies
