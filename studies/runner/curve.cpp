#include "studies/runner/curve.hpp"

#include "studies/runner/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace studies {

namespace {

std::optional<double> sauter_diameter(std::span<const Result> results, const std::string& case_id) {
  for (const Result& result : results)
    if (result.finding.case_id == case_id && result.finding.sauter_diameter)
      return result.finding.sauter_diameter;
  return std::nullopt;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// One quantity over the cases of a label, and the relative errors of its answers.
struct Sampled {
  std::vector<double> values, errors;

  std::optional<double> error() const {
    if (values.size() < 2 && errors.empty())
      return std::nullopt;
    const auto [least, most] = std::ranges::minmax(values);
    return (most - least) / 2 + (errors.empty() ? 0 : mean(errors) * std::abs(mean(values)));
  }
};

std::vector<std::string> labels_of(const Study& study, const std::string& curve) {
  std::vector<std::string> labels;
  for (const StudyCase& one : study.cases)
    if (one.curve == curve && std::ranges::find(labels, one.label) == labels.end())
      labels.push_back(one.label);
  return labels;
}

std::optional<CurvePoint> point_of(const Study& study, std::span<const Result> results, const std::string& curve,
                                   const std::string& label, const std::string& method) {
  std::vector<double> porosities;
  Sampled value, ratio;
  for (const StudyCase& one : study.cases) {
    if (one.curve != curve || one.label != label)
      continue;
    const Finding* finding = with_permeability(results, one.id, method);
    const auto diameter = sauter_diameter(results, one.id);
    if (!finding || !finding->told().porosity || !diameter)
      continue;
    const Bounded& k = *finding->permeability;
    porosities.push_back(*finding->told().porosity);
    value.values.push_back(k.value / (*diameter * *diameter));
    if (k.error)
      value.errors.push_back(*k.error / std::abs(k.value));
    if (const Finding* other = with_permeability(results, one.id, study.curve->compared_with))
      ratio.values.push_back(k.value / other->permeability->value);
  }
  if (porosities.empty())
    return std::nullopt;
  CurvePoint point{label, porosities.size(), mean(porosities), mean(value.values), value.error(), {}, {}};
  ratio.errors = value.errors;
  if (ratio.values.size() == porosities.size()) {
    point.ratio = mean(ratio.values);
    point.ratio_error = ratio.error();
  }
  return point;
}

/// One table of a curve; `cell` tells a point.
template <class Cell>
Table table_of(const Study& study, std::span<const Result> results, const std::string& curve, Cell cell) {
  Table table{{{"cases"}, {"number", true}, {"porosity", true}}, {}};
  std::vector<std::vector<CurvePoint>> columns;
  for (const StudyMethod& method : study.methods)
    if (auto points = curve_points(study, results, curve, method.name); !points.empty()) {
      table.columns.push_back({method.name, true});
      columns.push_back(std::move(points));
    }
  for (const std::string& label : labels_of(study, curve)) {
    std::vector<std::string> cells{label, "", ""};
    for (const auto& points : columns) {
      const auto found = std::ranges::find(points, label, &CurvePoint::label);
      cells.push_back(found == points.end() ? "" : cell(*found));
      if (found != points.end() && cells[1].empty()) {
        cells[1] = fmt::format("{}", found->cases);
        cells[2] = fmt::format("{:.3f}", found->porosity);
      }
    }
    if (std::ranges::any_of(cells.begin() + 3, cells.end(), [](const std::string& text) { return !text.empty(); }))
      table.rows.push_back(std::move(cells));
  }
  return table;
}

} // namespace

std::vector<std::string> curve_names(const Study& study) {
  std::vector<std::string> names;
  for (const StudyCase& one : study.cases)
    if (!one.curve.empty() && std::ranges::find(names, one.curve) == names.end())
      names.push_back(one.curve);
  return names;
}

std::vector<CurvePoint> curve_points(const Study& study, std::span<const Result> results, const std::string& curve,
                                     const std::string& method) {
  std::vector<CurvePoint> points;
  if (study.curve)
    for (const std::string& label : labels_of(study, curve))
      if (auto point = point_of(study, results, curve, label, method))
        points.push_back(std::move(*point));
  std::ranges::stable_sort(points, {}, &CurvePoint::porosity);
  return points;
}

std::vector<TitledTable> curve_tables(const Study& study, std::span<const Result> results) {
  std::vector<TitledTable> tables;
  const auto value = [](const CurvePoint& point) { return with_error(point.value, point.error); };
  const auto ratio = [](const CurvePoint& point) {
    return point.ratio ? with_error(*point.ratio, point.ratio_error) : "";
  };
  const auto add = [&](const std::string& title, Table table) {
    if (!table.rows.empty())
      tables.push_back({title, std::move(table)});
  };
  if (study.curve)
    for (const std::string& curve : curve_names(study)) {
      add(curve + ": k / d²", table_of(study, results, curve, value));
      if (const std::string& other = study.curve->compared_with; !other.empty())
        add(fmt::format("{}: k / k of {}", curve, other), table_of(study, results, curve, ratio));
    }
  return tables;
}

std::vector<Plot> curve_plots(const Study& study, std::span<const Result> results, const std::string& curve) {
  if (!study.curve)
    return {};
  Plot values{curve + ": permeability over the square of the Sauter diameter.",
              {"porosity"},
              {"k / d²", Scale::logarithmic},
              {}};
  Plot ratios{fmt::format("{}: the same over that of {}.", curve, study.curve->compared_with),
              {"porosity"},
              {"k / k of " + study.curve->compared_with},
              {}};
  for (std::size_t m = 0; m < study.methods.size(); ++m) {
    const std::string& method = study.methods[m].name;
    const bool line = std::ranges::find(study.curve->lines, method) != study.curve->lines.end();
    Series all{method, line ? Drawn::line_with_points : Drawn::points, static_cast<int>(m), {}};
    Series relative = all;
    for (const CurvePoint& point : curve_points(study, results, curve, method)) {
      all.points.push_back({point.porosity, point.value, {}, line ? std::nullopt : point.error});
      if (point.ratio)
        relative.points.push_back({point.porosity, *point.ratio, {}, line ? std::nullopt : point.ratio_error});
    }
    values.series.push_back(std::move(all));
    ratios.series.push_back(std::move(relative));
  }
  std::vector<Plot> plots{std::move(values), std::move(ratios)};
  std::erase_if(plots, &Plot::empty);
  return plots;
}

} // namespace studies
