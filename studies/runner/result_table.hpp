#pragma once

#include "studies/document/table.hpp"
#include "studies/runner/result.hpp"

#include <span>

namespace studies {

/// One line per case and method: size, permeability, differences, CPU seconds by how often they are paid, memory,
/// outcome, and the published figures when the study has any. Size and cost are of the finest mesh that answered.
Table result_table(const Study& study, std::span<const Result> results);

/// One line per stored run.
Table run_table(std::span<const Row> rows);

} // namespace studies
