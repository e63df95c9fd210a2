#include "studies/places/scatter.hpp"

#include <algorithm>
#include <cmath>

namespace studies {

int look_of(const Study& study, const std::string& method) {
  return static_cast<int>(std::ranges::find(study.methods, method, &StudyMethod::name) - study.methods.begin());
}

Plot scatter(std::span<const PlaceCase> cases, const Study& study, const std::string& what, std::string caption,
             const ChoosePairs& choose, const ChooseUnit& unit) {
  Plot plot{std::move(caption), {what + ", " + study.reference}, {what}, {}};
  double least = 0, most = 0;
  for (const StudyMethod& method : study.methods) {
    Series series{method.name, Drawn::small_points, look_of(study, method.name), {}};
    for (const PlaceCase& viewed : cases)
      for (const PlacePairs& pairs : choose(viewed))
        if (pairs.method == method.name)
          for (std::size_t i = 0; i < pairs.values.size(); ++i) {
            const PlotPoint point{pairs.reference[i] / unit(viewed), pairs.values[i] / unit(viewed)};
            if (std::isnan(point.x) || std::isnan(point.y))
              continue;
            series.points.push_back(point);
            least = std::min({least, point.x, point.y});
            most = std::max({most, point.x, point.y});
          }
    if (!series.points.empty())
      plot.series.push_back(std::move(series));
  }
  if (!plot.series.empty())
    plot.series.push_back({"", Drawn::dashed_line, -1, {{least, least}, {most, most}}});
  return plot;
}

} // namespace studies
