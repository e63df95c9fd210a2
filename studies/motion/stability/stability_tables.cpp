#include "studies/motion/stability/stability_tables.hpp"

#include "studies/runner/csv.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace studies {
namespace {

std::string number(double value) {
  return std::isnan(value) ? "not finite" : fmt::format("{:.4g}", value);
}

bool bounded(const Measure& measure) {
  return std::isfinite(measure.least) || std::isfinite(measure.most);
}

/// Of sizes, which are never below zero, only the upper bound is worth a word.
bool from_zero(const Measure& measure) {
  return measure.least == 0 || !std::isfinite(measure.least);
}

std::string bound(const Measure& measure) {
  if (measure.least == measure.most)
    return number(measure.least);
  if (!std::isfinite(measure.most))
    return "at least " + number(measure.least);
  return from_zero(measure) ? "at most " + number(measure.most)
                            : fmt::format("{} to {}", number(measure.least), number(measure.most));
}

/// How far a value is towards a bound, or out of it: the larger, the worse.
double badness(const Measure& measure) {
  if (std::isnan(measure.value))
    return Measure::none;
  if (!std::isfinite(measure.most))
    return measure.least - measure.value;
  return from_zero(measure) ? measure.value - measure.most
                            : std::max(measure.least - measure.value, measure.value - measure.most);
}

/// The measures of the first case that has some: all cases of a group have the same.
std::vector<Measure> measures_of(const std::vector<TrialRow>& group) {
  for (const TrialRow& row : group)
    if (!row.ours.measures.empty())
      return row.ours.measures;
  return {};
}

template <class Has>
bool any(const std::vector<TrialRow>& group, Has has) {
  return std::ranges::any_of(group, has);
}

} // namespace

std::vector<Expectation> expectations_of(const std::vector<TrialRow>& group) {
  const std::string& name = group.front().group;
  const auto finished = std::ranges::count(group, done, &TrialRow::outcome);
  const auto size = static_cast<std::ptrdiff_t>(group.size());
  std::vector<Expectation> list{
      {name + ": cases that end without a failure", fmt::format("{} of {}", finished, size), "all", finished == size}};
  const auto columns = measures_of(group);
  for (std::size_t m = 0; m < columns.size(); ++m) {
    if (!bounded(columns[m]))
      continue;
    const Measure* worst = nullptr;
    for (const TrialRow& row : group)
      if (row.outcome == done && (!worst || badness(row.ours.measures[m]) > badness(*worst)))
        worst = &row.ours.measures[m];
    list.push_back({fmt::format("{}: {}, the worst", name, worst->what), number(worst->value), bound(*worst),
                    std::ranges::all_of(group, [&](const TrialRow& row) {
                      return row.outcome != done || row.ours.measures[m].holds();
                    })});
  }
  return list;
}

Table trial_table(const std::vector<TrialRow>& group) {
  const auto columns = measures_of(group);
  const bool outcomes = any(group, [](const TrialRow& row) { return row.outcome != done; });
  const bool remarks = any(group, [](const TrialRow& row) { return !row.ours.remarks.empty(); });
  const bool theirs = any(group, [](const TrialRow& row) { return row.theirs.has_value(); });
  Table table{{{"case"}}, {}};
  if (outcomes)
    table.columns.push_back({"outcome"});
  for (const Measure& measure : columns)
    table.columns.push_back(
        {bounded(measure) ? fmt::format("{} ({})", measure.what, bound(measure)) : measure.what, true});
  if (remarks)
    table.columns.push_back({"remarks"});
  if (theirs)
    table.columns.push_back({"YADE"});
  for (const TrialRow& row : group) {
    std::vector<std::string> cells{row.name};
    if (outcomes)
      cells.push_back(row.outcome == done ? done : "**" + row.outcome + "**");
    for (std::size_t m = 0; m < columns.size(); ++m) {
      if (m >= row.ours.measures.size())
        cells.emplace_back();
      else if (const Measure& measure = row.ours.measures[m]; measure.holds())
        cells.push_back(number(measure.value));
      else
        cells.push_back("**" + number(measure.value) + "**");
    }
    if (remarks)
      cells.push_back(row.ours.remarks);
    if (theirs)
      cells.push_back(row.theirs ? row.theirs->words : "");
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table expectation_table(const std::vector<Expectation>& expectations) {
  Table table{{{"what"}, {"found", true}, {"bound"}, {"holds"}}, {}};
  for (const Expectation& one : expectations)
    table.rows.push_back({one.what, one.found, one.bound, one.holds ? "yes" : "NO"});
  return table;
}

std::string measures_csv(const std::vector<TrialRow>& rows) {
  const auto field = [](double value) { return std::isfinite(value) ? fmt::format("{:.6g}", value) : ""; };
  std::string text = to_csv({"group", "case", "measure", "value", "least", "most", "holds"});
  for (const TrialRow& row : rows)
    for (const Measure& measure : row.ours.measures)
      text += to_csv({row.group, row.name, measure.what, field(measure.value), field(measure.least),
                      field(measure.most), measure.holds() ? "yes" : "no"});
  return text;
}

std::string outcomes_csv(const std::vector<TrialRow>& rows) {
  std::string text = to_csv({"group", "case", "outcome", "holds", "remarks", "cpu_seconds", "yade"});
  for (const TrialRow& row : rows)
    text += to_csv({row.group, row.name, row.outcome, row.holds() ? "yes" : "no", row.ours.remarks,
                    fmt::format("{:.3g}", row.cpu_seconds), row.theirs ? row.theirs->words : ""});
  return text;
}

} // namespace studies
