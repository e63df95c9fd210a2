#pragma once

#include "studies/document/document.hpp"
#include "studies/runner/plan.hpp"
#include "studies/runner/result.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace studies {

/// A study's rows as one page: question, outcome, plots, table, what each comparison says, every run, where the numbers
/// come from. Everything in it is from the rows and their answers.
Document report(const Study& study, const Scope& scope, std::span<const Row> rows,
                const std::filesystem::path& answers);

/// The same results for programs, as JSON.
std::string results_json(const Study& study, std::span<const Result> results);

} // namespace studies
