#pragma once

#include "studies/document/document.hpp"

#include <string>

namespace studies {

/// The page as one HTML file that needs no other: tables sort by a click on a title and copy as CSV, it follows the
/// reader's light or dark scheme and can be switched, wide tables scroll by themselves. Its script sets
/// `data-ready` of the root element to the number of tables when it has run. A plot that was not drawn says so.
std::string to_html(const Document& document);

} // namespace studies
