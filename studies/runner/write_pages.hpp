#pragma once

#include "studies/document/document.hpp"

#include <filesystem>

namespace studies {

/// Writes report.md and report.html into the folder, plots drawn and the pictures that lie in the folder taken into the
/// HTML. A `readme`, in which a study says what was expected before it was run and what was found, goes into the HTML
/// too, folded, when it is there. Returns the path of report.html.
std::filesystem::path write_pages(Document document, const std::filesystem::path& folder,
                                  const std::filesystem::path& readme);

} // namespace studies
