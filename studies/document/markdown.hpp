#pragma once

#include "studies/document/document.hpp"

#include <string>
#include <string_view>

namespace studies {

/// The page as Markdown: blocks with an empty line between, nothing folded. Plots, and pictures without a file, are for
/// HTML only and left out.
std::string to_markdown(const Document& document);

/// Reads what to_markdown writes, no more of Markdown than that: to_markdown(from_markdown(text)) is the text again.
/// What was folded no longer is, and lines of a comment, from <!-- to -->, are left out.
Document from_markdown(std::string_view text);

} // namespace studies
