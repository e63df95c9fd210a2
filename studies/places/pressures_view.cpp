#include "studies/places/cut_in_space.hpp"
#include "studies/places/cut_picture.hpp"
#include "studies/places/place_views.hpp"
#include "studies/places/scatter.hpp"
#include "studies/runner/compare.hpp"
#include "studies/runner/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace studies {

namespace {

double drop(const PlaceCase& viewed) {
  return std::abs(viewed.rise);
}

struct Differences {
  std::size_t pores = 0;
  double rms = 0, mean = 0, worst = 0; // over the drop
  std::size_t worst_pore = 0;
};

Differences differences(const PlaceCase& viewed, const PlacePairs& pairs) {
  Differences found{0, rms_difference(pairs.values, pairs.reference) / drop(viewed), 0, 0, 0};
  for (std::size_t i = 0; i < pairs.values.size(); ++i) {
    const double difference = (pairs.values[i] - pairs.reference[i]) / drop(viewed);
    if (std::isnan(difference))
      continue;
    ++found.pores;
    found.mean += difference;
    if (std::abs(difference) > std::abs(found.worst)) {
      found.worst = difference;
      found.worst_pore = i;
    }
  }
  found.mean /= static_cast<double>(std::max<std::size_t>(found.pores, 1));
  return found;
}

Table table(std::span<const PlaceCase> cases) {
  Table table{{{"case"},
               {"method"},
               {"pores", true},
               {"rms", true},
               {"reference ±", true},
               {"mean", true},
               {"worst pore", true},
               {"at, of the box", true},
               {"share of the fluid", true}},
              {}};
  for (const PlaceCase& viewed : cases) {
    const auto& pores = viewed.network.pores;
    double fluid = 0;
    for (const double volume : pores.void_volume)
      fluid += volume;
    for (const PlacePairs& pairs : viewed.pressures()) {
      const Differences found = differences(viewed, pairs);
      const pfv::Vec3 at =
          (pores.centre[found.worst_pore] - viewed.network.box.lower).cwiseQuotient(viewed.network.box.size());
      const auto& error = viewed.reference.pore_pressures->error;
      table.rows.push_back({viewed.one.label, pairs.method, fmt::format("{}", found.pores), percent(found.rms),
                            error ? percent(*error / drop(viewed)) : "",
                            viewed.reference.free_level ? "" : percent(found.mean), percent(found.worst),
                            fmt::format("{:.2f} {:.2f} {:.2f}", at.x(), at.y(), at.z()),
                            percent(pores.void_volume[found.worst_pore] / fluid)});
    }
  }
  return table;
}

/// Fluid-weighted means of what pressures are above the straight line of the mean gradient, over the drop.
class Slices {
public:
  Slices(const PlaceCase& viewed, const std::vector<double>& pressures) {
    const auto& network = viewed.network;
    const int axis = pfv::index(viewed.axis);
    for (std::size_t i = 0; i < pressures.size(); ++i) {
      if (std::isnan(pressures[i]))
        continue;
      const double at = (network.pores.centre[i][axis] - network.box.lower[axis]) / network.box.size()[axis];
      const auto slice = static_cast<std::size_t>(std::clamp(at * count, 0.0, count - 1.0));
      volume_[slice] += network.pores.void_volume[i];
      sum_[slice] += network.pores.void_volume[i] * (pressures[i] - viewed.rise * at) / drop(viewed);
    }
  }

  double mean() const {
    return std::accumulate(sum_.begin(), sum_.end(), 0.0) / std::accumulate(volume_.begin(), volume_.end(), 0.0);
  }

  /// By the place along the box, less `level`.
  std::vector<PlotPoint> points(double level) const {
    std::vector<PlotPoint> points;
    for (std::size_t s = 0; s < count; ++s)
      if (volume_[s] > 0)
        points.push_back({(static_cast<double>(s) + 0.5) / count, sum_[s] / volume_[s] - level});
    return points;
  }

private:
  static constexpr std::size_t count = 12;
  std::array<double, count> volume_{}, sum_{};
};

Plot profile(const PlaceCase& viewed, const Study& study) {
  Plot plot{fmt::format("{}: mean pressure in slices along the flow, weighted by the fluid in the pores, less the "
                        "straight line with the reference's mean.",
                        viewed.one.label),
            {"place along the box"},
            {"(p - line) / drop"},
            {}};
  const auto all = viewed.pressures();
  if (all.empty())
    return plot;
  const Slices reference(viewed, all.front().reference);
  const auto add = [&](const std::string& method, const Slices& slices) {
    plot.series.push_back({method, Drawn::line_with_points, look_of(study, method), slices.points(reference.mean())});
  };
  add(study.reference, reference);
  for (const PlacePairs& pairs : all)
    add(pairs.method, Slices(viewed, pairs.values));
  return plot;
}

} // namespace

void add_pressures(std::span<const PlaceCase> cases, const Study& study, Document& page) {
  Table differences = table(cases);
  if (differences.rows.empty())
    return;
  page.add(Heading{"Pressures in pores"});
  page.add(
      Paragraph{"Differences from the reference over the pressure drop, in every pore at its centre where that "
                "lies in the fluid. *Mean* is the bias; there is none where nothing sets the level of the pressure."});
  page.add(std::move(differences));
  page.add(scatter(
      cases, study, "pressure / drop", "Pressure in every pore, all cases.",
      [](const PlaceCase& viewed) { return viewed.pressures(); }, drop));
  for (const PlaceCase& viewed : cases)
    page.add(profile(viewed, study));
  for (const auto& figures : {pressure_cuts(cases), pressure_in_space(cases)})
    for (const Figure& figure : figures)
      page.add(figure);
}

} // namespace studies
