#pragma once

#include "studies/document/document.hpp"
#include "studies/runner/result.hpp"

#include <map>
#include <span>
#include <string>

namespace studies {

/// What a study with `places` adds to its report: methods beside the reference in every pore, on every sphere, through
/// every throat, as tables, scatter plots and a cut. Cases without an answer of the reference are left out. Throws
/// pfv::InputError when stored answers are of other pores and throats than PFV makes now.
void add_places(const Study& study, std::span<const Result> results, Document& page);

/// The same as numbers, by file name; see place_files.
std::map<std::string, std::string> place_files(const Study& study, std::span<const Result> results);

} // namespace studies
