#include "studies/runner/report_plots.hpp"

#include "studies/runner/cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace studies {

namespace {

constexpr double near = 0.05; // of 1: the closer look

std::vector<const Result*> of_method(std::span<const Result> results, const std::string& method) {
  std::vector<const Result*> found;
  for (const Result& result : results)
    if (result.finding.method == method)
      found.push_back(&result);
  std::ranges::stable_sort(found, {}, [](const Result* one) { return one->finding.told().spheres; });
  return found;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : std::sqrt(values[middle - 1] * values[middle]);
}

/// Of the case, told from others of that label by its number of spheres.
std::string place_of(const Study& study, const StudyCase& one, const Finding& finding) {
  return std::ranges::count(study.cases, one.label, &StudyCase::label) > 1
             ? fmt::format("{}, {}", one.label, finding.told().spheres)
             : one.label;
}

/// Half width of k / k of the reference: what is known of the errors of both.
std::optional<double> ratio_error(const Finding& finding, const Finding& reference) {
  const Bounded &k = *finding.permeability, &k_reference = *reference.permeability;
  if (!k.error && !k_reference.error)
    return std::nullopt;
  return (k.error.value_or(0) + k_reference.error.value_or(0)) / std::abs(k_reference.value);
}

/// Those that no other is both left of and below, and the corner beyond the last.
std::vector<PlotPoint> pareto_front(std::vector<PlotPoint> points) {
  std::ranges::sort(points, {}, [](const PlotPoint& p) { return std::pair(p.x, p.y); });
  std::vector<PlotPoint> front;
  for (const PlotPoint& point : points)
    if (front.empty() || point.y < front.back().y)
      front.push_back({point.x, point.y});
  return front;
}

/// Of one more quantity of each method against the number of spheres.
template <class Value>
Plot against_spheres(const Study& study, std::span<const Result> results, const std::string& label, Value value) {
  Plot plot{fmt::format("{} against the number of spheres.", label),
            {"spheres", Scale::logarithmic},
            {label, Scale::logarithmic},
            {}};
  for (std::size_t m = 0; m < study.methods.size(); ++m) {
    Series series{study.methods[m].name, Drawn::line_with_points, static_cast<int>(m), {}};
    for (const Result* result : of_method(results, series.name))
      if (result->finding.answered()) {
        const Row& row = result->finding.told();
        if (const double y = value(row); y > 0)
          series.points.push_back({static_cast<double>(row.spheres), y});
      }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

} // namespace

std::vector<Plot> permeability_plots(const Study& study, std::span<const Result> results) {
  Plot all{
      "Permeability over that of the reference, " + study.reference +
          ", extrapolated where a method has several meshes. Bars: errors of the answer and of the reference, added.",
      {"k / k of the reference"},
      {},
      {}};
  std::map<std::string, double> places;
  for (const StudyCase& one : study.cases)
    if (const Finding* reference = with_permeability(results, one.id, study.reference)) {
      places[one.id] = static_cast<double>(all.y.categories.size());
      all.y.categories.push_back(place_of(study, one, *reference));
    }
  double least = 1, most = 1;
  const double lanes = static_cast<double>(study.methods.size());
  for (std::size_t m = 0; m < study.methods.size(); ++m) {
    Series series{study.methods[m].name, Drawn::points, static_cast<int>(m), {}};
    for (const Result* result : of_method(results, series.name))
      if (const auto& difference = result->comparison.permeability) {
        const double ratio = 1 + difference->value;
        const double lane = 0.7 * ((static_cast<double>(m) + 0.5) / lanes - 0.5);
        const Finding& reference = *with_permeability(results, result->finding.case_id, study.reference);
        series.points.push_back(
            {ratio, places[result->finding.case_id] + lane, ratio_error(result->finding, reference)});
        least = std::min(least, ratio);
        most = std::max(most, ratio);
      }
    if (!series.points.empty())
      all.series.push_back(std::move(series));
  }
  if (all.empty())
    return {};
  const double rows = static_cast<double>(all.y.categories.size());
  all.series.push_back({"", Drawn::dashed_line, -1, {{1, -0.5}, {1, rows - 0.5}}});
  all.height = 160 + static_cast<int>(rows * std::clamp(9.0 * lanes, 18.0, 40.0));
  if (most / least <= 1 + 2 * near)
    return {all};
  if (least > 0 && most / least > 3)
    all.x.scale = Scale::logarithmic;
  Plot close = all;
  close.caption =
      fmt::format("The same within {:.0f} % of the reference; what lies further off is not drawn.", 100 * near);
  close.x.scale = Scale::linear;
  close.x.range = {1 - near, 1 + near};
  const bool any = std::ranges::any_of(close.series, [](const Series& series) {
    return series.look >= 0 &&
           std::ranges::any_of(series.points, [](const PlotPoint& p) { return std::abs(p.x - 1) <= near; });
  });
  return any ? std::vector{all, close} : std::vector{all};
}

Plot error_plot(const Study& study, std::span<const Result> results) {
  Plot plot{"Error of the permeability at every mesh size against CPU seconds, meshing included. Small marks: single "
            "cases, with the reference's own error as bars; large ones: medians over the cases, from coarse to fine "
            "meshes. Dashed: none of these medians is both faster and closer.",
            {"CPU seconds", Scale::logarithmic},
            {"relative error of k", Scale::logarithmic},
            {}};
  if (study.scaling) // asks for cost, not for errors
    return plot;
  std::vector<PlotPoint> medians;
  std::vector<Series> lines;
  for (std::size_t m = 0; m < study.methods.size(); ++m) {
    const std::string& method = study.methods[m].name;
    Series runs{"", Drawn::small_points, static_cast<int>(m), {}};
    std::map<double, std::pair<std::vector<double>, std::vector<double>>, std::greater<>> by_size;
    for (const Result* result : of_method(results, method)) {
      const Finding* reference = with_permeability(results, result->finding.case_id, study.reference);
      if (!reference || (method == study.reference && !reference->permeability->error))
        continue;
      if (!reference->permeability->error && reference->told().convergence_order)
        continue;
      const double k = reference->permeability->value;
      for (const Row& row : result->finding.rows) {
        if (row.status != Status::answered || !row.permeability)
          continue;
        PlotPoint point{cost(row.stages).total(), std::abs(*row.permeability / k - 1)};
        if (!(point.x > 0 && point.y > 0))
          continue;
        by_size[row.mesh_size].first.push_back(point.x);
        by_size[row.mesh_size].second.push_back(point.y);
        if (reference->permeability->error)
          point.y_error = *reference->permeability->error / k;
        runs.points.push_back(point);
      }
    }
    Series line{method, Drawn::line_with_points, static_cast<int>(m), {}};
    for (const auto& [size, values] : by_size) {
      line.points.push_back({median(values.first), median(values.second)});
      medians.push_back(line.points.back());
    }
    if (line.points.empty())
      continue;
    plot.series.push_back(std::move(runs));
    lines.push_back(std::move(line));
  }
  if (plot.series.empty())
    return plot;
  if (lines.size() > 1)
    plot.series.push_back({"none faster and closer", Drawn::dashed_steps, -1, pareto_front(medians)});
  plot.series.insert(plot.series.end(), lines.begin(), lines.end());
  return plot;
}

std::vector<Plot> scaling_plots(const Study& study, std::span<const Result> results) {
  if (!study.scaling)
    return {};
  const auto seconds = [](const Row& row) { return cost(row.stages).total(); };
  const auto megabytes = [](const Row& row) { return static_cast<double>(row.memory_bytes) / 1e6; };
  std::vector<Plot> plots{against_spheres(study, results, "CPU seconds", seconds),
                          against_spheres(study, results, "memory (MB)", megabytes)};
  plots[0].caption = "CPU seconds of the first iteration, from the spheres to the forces on them.";
  plots[1].caption = "Memory that the method adds to its process.";
  std::erase_if(plots, &Plot::empty);
  return plots;
}

} // namespace studies
