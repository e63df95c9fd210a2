#pragma once

#include "studies/document/table.hpp"
#include "studies/runner/row.hpp"

#include <filesystem>
#include <span>

namespace studies {

/// What the rows were made with and on, one line per fact: commit, compiler, flags, machine, dates. A fact that is not
/// the same for all rows has all its values.
Table provenance(std::span<const Row> rows);

/// What the methods themselves note of each run (versions, settings), one line per method and note.
Table method_notes(std::span<const Row> rows, const std::filesystem::path& answers);

} // namespace studies
