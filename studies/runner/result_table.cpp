#include "studies/runner/result_table.hpp"

#include "studies/runner/cost.hpp"
#include "studies/runner/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace studies {

namespace {

const StudyCase& case_of(const Study& study, const std::string& id) {
  return *std::ranges::find(study.cases, id, &StudyCase::id);
}

std::string difference_cell(const std::optional<Difference>& difference, bool signed_value) {
  if (!difference)
    return "";
  if (difference->unresolved())
    return fmt::format("unresolved (< {})", percent(*difference->reference_error));
  std::string text = fmt::format("{}{}", signed_value && difference->value > 0 ? "+" : "", percent(difference->value));
  return difference->error ? text + fmt::format(" ± {}", percent(*difference->error)) : text;
}

std::string outcome_cell(const Result& result) {
  const Row& row = result.finding.told();
  if (!result.finding.answered())
    return std::string(name(row.status));
  std::string text;
  if (!result.comparison.outcome)
    text = "reference";
  else if (result.comparison.outcome == Outcome::agrees || result.comparison.outcome == Outcome::differs)
    text = name(*result.comparison.outcome);
  else
    text = fmt::format("no reference ({})", name(*result.comparison.outcome));
  return result.finding.trouble().empty() ? text : text + ", one mesh size missing";
}

std::vector<std::string> published_cells(const StudyCase& one, const std::string& method) {
  const auto found = std::ranges::find(one.published, method, &PublishedFigure::method);
  if (found == one.published.end())
    return {"", ""};
  return {found->unknowns ? count(*found->unknowns) : "n.a.",
          found->cpu_seconds ? seconds(*found->cpu_seconds) : "n.a."};
}

bool has_published(const Study& study) {
  return std::ranges::any_of(study.cases, [](const StudyCase& one) { return !one.published.empty(); });
}

} // namespace

Table result_table(const Study& study, std::span<const Result> results) {
  Table table{{{"case"},
               {"spheres", true},
               {"method"},
               {"dofs", true},
               {"k [m²]", true},
               {"k difference", true},
               {"force difference", true}},
              {}};
  const auto has = [&](auto member) {
    return std::ranges::any_of(results, [&](const Result& result) { return (result.comparison.*member).has_value(); });
  };
  const bool pressures = has(&Comparison::pressures), fluxes = has(&Comparison::fluxes);
  if (pressures)
    table.columns.push_back({"pressure difference", true});
  if (fluxes)
    table.columns.push_back({"throat flux difference", true});
  for (const char* title : {"mesh s", "once s", "solve s", "memory"})
    table.columns.push_back({title, true});
  table.columns.push_back({"outcome"});
  const bool published = has_published(study);
  if (published)
    for (const char* title : {"published dofs", "published s"})
      table.columns.push_back({title, true});

  for (const Result& result : results) {
    const Row& row = result.finding.told();
    const bool answered = result.finding.answered();
    const StudyCase& one = case_of(study, result.finding.case_id);
    const auto& k = result.finding.permeability;
    const Cost split = cost(row.stages);
    std::vector<std::string> cells{one.label, fmt::format("{}", row.spheres), row.method};
    std::vector<std::string> figures{
        count(static_cast<double>(row.unknowns)), k ? with_error(k->value, k->error) : "n.a.",
        difference_cell(result.comparison.permeability, true), difference_cell(result.comparison.forces, false)};
    if (pressures)
      figures.push_back(difference_cell(result.comparison.pressures, false));
    if (fluxes)
      figures.push_back(difference_cell(result.comparison.fluxes, false));
    for (const double stage : {split.mesh, split.once, split.solve})
      figures.push_back(seconds(stage));
    figures.push_back(bytes(static_cast<double>(row.memory_bytes)));
    for (const std::string& figure : figures)
      cells.push_back(answered ? figure : "");
    cells.push_back(outcome_cell(result));
    if (!answered && row.status == Status::over_budget)
      cells.back() += " (" + row.message + ")";
    if (published)
      for (const std::string& cell : published_cells(one, row.method))
        cells.push_back(cell);
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table run_table(std::span<const Row> rows) {
  Table table{{{"case"},
               {"method"},
               {"mesh size", true},
               {"status"},
               {"dofs", true},
               {"k [m²]", true},
               {"stages [CPU s]"},
               {"process [CPU s]", true},
               {"memory", true},
               {"repeats", true},
               {"expected [CPU s]", true}},
              {}};
  for (const Row& row : rows) {
    std::string stages;
    for (const pfv::Stage& stage : row.stages)
      stages += fmt::format("{}{} {}", stages.empty() ? "" : ", ", stage.name, seconds(stage.cpu_seconds));
    const bool answered = row.status == Status::answered;
    table.rows.push_back({row.case_id, row.method, row.convergence_order ? fmt::format("{}", row.mesh_size) : "none",
                          std::string(name(row.status)), answered ? count(static_cast<double>(row.unknowns)) : "",
                          row.permeability ? with_error(*row.permeability, std::nullopt) : "", stages,
                          row.repeats > 0 ? seconds(row.process_cpu_seconds) : "",
                          row.repeats > 0 ? bytes(static_cast<double>(row.memory_bytes)) : "",
                          fmt::format("{}", row.repeats), seconds(row.estimated_cpu_seconds)});
  }
  return table;
}

} // namespace studies
