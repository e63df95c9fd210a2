#pragma once

#include "studies/document/document.hpp"

#include <filesystem>

namespace studies {

/// Writes report.md and report.html into the folder, plots drawn and the pictures that lie in the folder taken into the
/// HTML. Returns the path of report.html.
std::filesystem::path write_pages(Document document, const std::filesystem::path& folder);

} // namespace studies
