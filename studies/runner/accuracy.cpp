#include "studies/runner/accuracy.hpp"

#include "studies/runner/cost.hpp"
#include "studies/runner/number_text.hpp"
#include "studies/runner/quantile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ranges>

namespace studies {

namespace {

/// An answer to compare: how far off and at what cost.
struct Attempt {
  double error, cpu_seconds;
};

/// From fine to coarse.
std::vector<Attempt> mesh_by_mesh(const Finding& finding, const Bounded& reference) {
  std::vector<Attempt> attempts;
  for (const Row& row : std::views::reverse(finding.rows))
    if (row.status == Status::answered && row.permeability)
      attempts.push_back({std::abs(*row.permeability / reference.value - 1), cost(row.stages).total()});
  return attempts;
}

std::vector<Attempt> all_meshes(const Study& study, const Finding& finding, const Bounded& reference) {
  if (!finding.permeability || !finding.permeability->error)
    return {};
  Attempt attempt{std::abs(finding.permeability->value / reference.value - 1), 0};
  for (const Row& row : finding.rows)
    attempt.cpu_seconds += row.status == Status::answered ? cost(row.stages).total() : 0;
  if (finding.method == study.reference)
    attempt.error = 0; // its own error is added for all
  return {attempt};
}

std::string cell(const CostOfAccuracy& found) {
  if (found.cases == 0)
    return "not told";
  if (found.cpu_seconds.empty())
    return "in none";
  const std::string told = seconds(quantile(found.cpu_seconds, 0.5));
  return found.cpu_seconds.size() == found.cases
             ? told
             : fmt::format("{} (in {} of {})", told, found.cpu_seconds.size(), found.cases);
}

} // namespace

CostOfAccuracy cost_of_accuracy(const Study& study, std::span<const Result> results, const std::string& method,
                                double level, bool extrapolated) {
  CostOfAccuracy found;
  for (const Result& result : results) {
    const Finding& finding = result.finding;
    if (finding.method != method)
      continue;
    const Finding* reference = with_permeability(results, finding.case_id, study.reference);
    if (!reference || !reference->permeability->error)
      continue;
    const Bounded& k = *reference->permeability;
    const double uncertain = *k.error / std::abs(k.value);
    if (uncertain > level / 2)
      continue;
    ++found.cases;
    std::optional<double> coarsest;
    for (const Attempt& attempt : extrapolated ? all_meshes(study, finding, k) : mesh_by_mesh(finding, k)) {
      if (attempt.error + uncertain > level)
        break;
      coarsest = attempt.cpu_seconds;
    }
    if (coarsest)
      found.cpu_seconds.push_back(*coarsest);
  }
  return found;
}

Table accuracy_table(const Study& study, std::span<const Result> results) {
  Table table{{{"method"}}, {}};
  if (!study.accuracy)
    return table;
  for (const double level : study.accuracy->levels)
    table.columns.push_back({"within " + percent(level), true});
  const auto add = [&](const std::string& method, bool extrapolated) {
    std::vector<std::string> line{extrapolated ? method + ", extrapolated" : method};
    for (const double level : study.accuracy->levels)
      line.push_back(cell(cost_of_accuracy(study, results, method, level, extrapolated)));
    table.rows.push_back(std::move(line));
  };
  for (const StudyMethod& method : study.methods) {
    const auto answers = [&](auto of) {
      return std::ranges::any_of(results, [&](const Result& result) {
        return result.finding.method == method.name && result.finding.answered() && of(result.finding);
      });
    };
    if (answers([](const Finding& finding) { return finding.permeability.has_value(); }))
      add(method.name, false);
    if (answers([](const Finding& finding) { return finding.permeability && finding.permeability->error; }))
      add(method.name, true);
  }
  return table;
}

} // namespace studies
