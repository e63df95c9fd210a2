#pragma once

#include "studies/document/document.hpp"
#include "studies/runner/row.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace studies {

/// The README.md of a study's folder; empty for a study without a folder.
std::filesystem::path readme_of(const std::filesystem::path& study_folder);

/// Puts the pages, the rows and other files, text by name, into the results of a study's folder, and says so.
void publish(const Document& page, const std::vector<Row>& rows, const std::filesystem::path& study_folder,
             const std::map<std::string, std::string>& files = {});

} // namespace studies
