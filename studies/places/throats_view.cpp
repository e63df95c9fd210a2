#include "studies/places/place_views.hpp"
#include "studies/places/scatter.hpp"
#include "studies/runner/compare.hpp"
#include "studies/runner/number_text.hpp"
#include "studies/runner/quantile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace studies {

namespace {

constexpr std::array openness_steps{0.0, 0.2, 0.3, 0.4, 0.5, 1.0};

/// S_f / S
double openness(const PlaceCase& viewed, std::size_t throat) {
  return viewed.network.throats.fluid_area[throat] / viewed.network.throats.area[throat];
}

/// Conductance over the reference's against openness, of the throats where both are known.
std::vector<PlotPoint> ratios(const PlaceCase& viewed, const PlacePairs& pairs) {
  std::vector<PlotPoint> points;
  for (std::size_t t = 0; t < pairs.values.size(); ++t)
    if (const double ratio = pairs.values[t] / pairs.reference[t]; !std::isnan(ratio))
      points.push_back({openness(viewed, t), ratio});
  return points;
}

std::string quartiles(std::span<const PlotPoint> points, double from, double to) {
  std::vector<double> ratios;
  for (const PlotPoint& point : points)
    if (point.x >= from && (point.x < to || to == openness_steps.back()))
      ratios.push_back(point.y);
  if (ratios.size() < 4)
    return "";
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", quantile(ratios, 0.5), quantile(ratios, 0.25),
                     quantile(ratios, 0.75));
}

Table flux_table(std::span<const PlaceCase> cases) {
  Table table{{{"case"},
               {"method"},
               {"throats", true},
               {"flux rms", true},
               {"reference ±", true},
               {"conductances told", true},
               {"over the reference's: median (quartiles)", true}},
              {}};
  for (const PlaceCase& viewed : cases) {
    const auto conductances = viewed.conductances();
    for (const PlacePairs& pairs : viewed.fluxes()) {
      const auto& field = *viewed.reference.throat_fluxes;
      const double unit = rms(field.values);
      std::vector<PlotPoint> told;
      if (const auto found = std::ranges::find(conductances, pairs.method, &PlacePairs::method);
          found != conductances.end())
        told = ratios(viewed, *found);
      table.rows.push_back({viewed.one.label, pairs.method, fmt::format("{}", pairs.values.size()),
                            percent(rms_difference(pairs.values, pairs.reference) / unit),
                            field.error ? percent(*field.error / unit) : "", fmt::format("{}", told.size()),
                            quartiles(told, openness_steps.front(), openness_steps.back())});
    }
  }
  return table;
}

/// Over all cases, a line for each method, a column for each interval of openness.
Table openness_table(std::span<const PlaceCase> cases, const Study& study) {
  Table table{{{"method"}}, {}};
  for (std::size_t i = 0; i + 1 < openness_steps.size(); ++i)
    table.columns.push_back({fmt::format("{:.1f} to {:.1f}", openness_steps[i], openness_steps[i + 1]), true});
  for (const StudyMethod& method : study.methods) {
    std::vector<PlotPoint> told;
    for (const PlaceCase& viewed : cases)
      for (const PlacePairs& pairs : viewed.conductances())
        if (pairs.method == method.name)
          std::ranges::copy(ratios(viewed, pairs), std::back_inserter(told));
    if (told.empty())
      continue;
    std::vector<std::string> line{method.name};
    for (std::size_t i = 0; i + 1 < openness_steps.size(); ++i)
      line.push_back(quartiles(told, openness_steps[i], openness_steps[i + 1]));
    table.rows.push_back(std::move(line));
  }
  return table;
}

Plot against_openness(std::span<const PlaceCase> cases, const Study& study) {
  Plot plot{"Conductance of every throat over the reference's, against how open it is, all cases.",
            {"S_f / S"},
            {"K / K of the reference", Scale::logarithmic},
            {}};
  for (const StudyMethod& method : study.methods) {
    Series series{method.name, Drawn::small_points, look_of(study, method.name), {}};
    for (const PlaceCase& viewed : cases)
      for (const PlacePairs& pairs : viewed.conductances())
        if (pairs.method == method.name)
          std::ranges::copy(ratios(viewed, pairs), std::back_inserter(series.points));
    if (!series.points.empty())
      plot.series.push_back(std::move(series));
  }
  if (!plot.series.empty())
    plot.series.push_back({"", Drawn::dashed_line, -1, {{0, 1}, {1, 1}}});
  return plot;
}

} // namespace

void add_throats(std::span<const PlaceCase> cases, const Study& study, Document& page) {
  Table fluxes = flux_table(cases);
  if (fluxes.rows.empty())
    return;
  page.add(Heading{"Throats"});
  page.add(Paragraph{"Fluxes: rms of the differences over the rms flux. A conductance is flux over fall of pressure "
                     "between the centres of the two pores, both of the same method; it is told where the reference's "
                     "flux and fall are at least three times its errors of them."});
  page.add(std::move(fluxes));
  page.add(Heading{"Conductance over the reference's, by openness S_f / S: median (quartiles), all cases", 3});
  page.add(openness_table(cases, study));
  if (Plot plot = against_openness(cases, study); !plot.empty())
    page.add(std::move(plot));
  page.add(scatter(
      cases, study, "flux / rms flux", "Flux through every throat, all cases.",
      [](const PlaceCase& viewed) { return viewed.fluxes(); },
      [](const PlaceCase& viewed) { return rms(viewed.reference.throat_fluxes->values); }));
}

} // namespace studies
