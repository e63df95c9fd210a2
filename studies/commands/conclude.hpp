#pragma once

#include "studies/runner/plan.hpp"
#include "studies/runner/row.hpp"

#include <filesystem>
#include <vector>

namespace studies {

/// Writes the report of rows to `folder`/report.md and report.html, and prints the table and where the report lies, or
/// JSON instead.
void conclude(const Study& study, const Scope& scope, const std::vector<Row>& rows,
              const std::filesystem::path& answers, const std::filesystem::path& folder, bool json);

} // namespace studies
