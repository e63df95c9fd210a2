#include "studies/runner/scaling.hpp"

#include "reference/answer.hpp"
#include "studies/runner/cost.hpp"
#include "studies/runner/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace studies {

namespace {

/// What a method took on one packing.
struct Point {
  const Row* row;
  Cost cost;

  double spheres() const { return static_cast<double>(row->spheres); }
  double memory() const { return static_cast<double>(row->memory_bytes); }
  bool answered() const { return row->status == Status::answered; }
  double stage(const std::string& name) const {
    const auto found = std::ranges::find(row->stages, name, &pfv::Stage::name);
    return found == row->stages.end() ? 0 : found->cpu_seconds;
  }
};

std::vector<Point> points_of(const std::string& method, std::span<const Result> results) {
  std::vector<Point> points;
  for (const Result& result : results)
    if (result.finding.method == method)
      points.push_back({&result.finding.told(), cost(result.finding.told().stages)});
  std::ranges::stable_sort(points, {}, &Point::spheres);
  return points;
}

// Those of the first iteration, in the order they come.
std::vector<std::string> stage_names(const std::vector<Point>& points) {
  std::vector<std::string> names;
  for (const Point& point : points)
    for (const pfv::Stage& stage : point.row->stages)
      if (!stage.name.starts_with(reference::repeat_prefix) && std::ranges::find(names, stage.name) == names.end())
        names.push_back(stage.name);
  return names;
}

// Like a number of seconds; empty when there is nothing to tell.
std::string positive(double value) {
  return value > 0 && std::isfinite(value) ? seconds(value) : "";
}

Table cost_table(const std::vector<Point>& points, const std::vector<std::string>& stages,
                 const std::string& unit_stage) {
  Table table{{{"spheres", true}}, {}};
  for (const std::string& stage : stages)
    table.columns.push_back({stage, true});
  table.columns.push_back({"all", true});
  table.columns.push_back({"µs per sphere", true});
  if (!unit_stage.empty())
    table.columns.push_back({"all / " + unit_stage, true});
  for (const char* title : {"repeated step", "memory", "bytes per sphere"})
    table.columns.push_back({title, true});
  for (const Point& point : points) {
    std::vector<std::string> cells{fmt::format("{}", point.row->spheres)};
    if (point.answered()) {
      for (const std::string& stage : stages)
        cells.push_back(positive(point.stage(stage)));
      const double all = point.cost.total();
      cells.push_back(positive(all));
      cells.push_back(positive(1e6 * all / point.spheres()));
      if (!unit_stage.empty())
        cells.push_back(positive(all / point.stage(unit_stage)));
      cells.push_back(positive(point.cost.repeat));
      cells.push_back(bytes(point.memory()));
      cells.push_back(count(point.memory() / point.spheres()));
    } else {
      cells.resize(1 + stages.size());
      cells.emplace_back(name(point.row->status));
      cells.resize(table.columns.size());
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

template <class Value>
std::string exponent_cell(const Point& small, const Point& large, Value value) {
  const auto slope = exponent(small.spheres(), value(small), large.spheres(), value(large));
  return slope ? fmt::format("{:.2f}", *slope) : "";
}

Table exponent_table(const std::vector<Point>& answered, const std::vector<std::string>& stages) {
  Table table{{{"spheres", true}}, {}};
  for (const std::string& stage : stages)
    table.columns.push_back({stage, true});
  for (const char* title : {"all", "repeated step", "memory"})
    table.columns.push_back({title, true});
  for (std::size_t i = 1; i < answered.size(); ++i) {
    const Point& small = answered[i - 1];
    const Point& large = answered[i];
    std::vector<std::string> cells{fmt::format("{} to {}", small.row->spheres, large.row->spheres)};
    for (const std::string& stage : stages)
      cells.push_back(exponent_cell(small, large, [&](const Point& point) { return point.stage(stage); }));
    cells.push_back(exponent_cell(small, large, [](const Point& point) { return point.cost.total(); }));
    cells.push_back(exponent_cell(small, large, [](const Point& point) { return point.cost.repeat; }));
    cells.push_back(exponent_cell(small, large, [](const Point& point) { return point.memory(); }));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

void add_ratios(const std::string& method, const std::vector<Point>& points, const std::vector<Point>& others,
                Table& table) {
  for (const Point& point : points) {
    const auto other = std::ranges::find(others, point.row->case_id, [](const Point& one) { return one.row->case_id; });
    if (other == others.end())
      continue;
    std::vector<std::string> cells{method, fmt::format("{}", point.row->spheres)};
    if (point.answered() && other->answered()) {
      cells.push_back(positive(other->cost.total() / point.cost.total()));
      cells.push_back(positive(other->cost.repeat / point.cost.repeat));
      cells.push_back(positive(other->memory() / point.memory()));
    } else {
      const Row& without = point.answered() ? *other->row : *point.row;
      cells.push_back(fmt::format("{} {}", without.method, name(without.status)));
      cells.resize(table.columns.size());
    }
    table.rows.push_back(std::move(cells));
  }
}

} // namespace

std::optional<double> exponent(double n_small, double small, double n_large, double large) {
  if (!(n_small > 0 && n_large > 0 && small > 0 && large > 0) || n_small == n_large)
    return std::nullopt;
  return std::log(large / small) / std::log(n_large / n_small);
}

std::vector<TitledTable> scaling_tables(const Study& study, std::span<const Result> results) {
  std::vector<TitledTable> tables;
  if (!study.scaling)
    return tables;
  for (const StudyMethod& method : study.methods) {
    std::vector<Point> points = points_of(method.name, results);
    const auto stages = stage_names(points);
    const bool has_unit = std::ranges::find(stages, study.scaling->unit_stage) != stages.end();
    if (!points.empty())
      tables.push_back({method.name + ", CPU seconds by stage",
                        cost_table(points, stages, has_unit ? study.scaling->unit_stage : "")});
    std::erase_if(points, [](const Point& point) { return !point.answered(); });
    if (points.size() > 1)
      tables.push_back({method.name + ", exponents", exponent_table(points, stages)});
  }
  if (const std::string& other = study.scaling->compared_with; !other.empty()) {
    Table ratios{{{"method"}, {"spheres", true}, {"first iteration", true}, {"repeated step", true}, {"memory", true}},
                 {}};
    const auto others = points_of(other, results);
    for (const StudyMethod& method : study.methods)
      if (method.name != other)
        add_ratios(method.name, points_of(method.name, results), others, ratios);
    if (!ratios.rows.empty())
      tables.push_back({other + " / method", ratios});
  }
  return tables;
}

} // namespace studies
