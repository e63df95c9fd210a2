#pragma once

#include "studies/document/document.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace studies {

/// A study and where its pages lie.
struct IndexEntry {
  std::string name;
  std::string title;            // told when there is no report
  std::filesystem::path folder; // of report.md and report.html
};

/// One line per study: what it is, how it came out, of when and of which sources, all from its report.md. Links are
/// from the folder that the index goes to. A study without a report says so.
Document index_page(std::span<const IndexEntry> entries, const std::filesystem::path& index_folder);

} // namespace studies
