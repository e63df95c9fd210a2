#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace studies {

enum class Scale { linear, logarithmic };

struct PlotAxis {
  std::string label;
  Scale scale = Scale::linear;
  std::optional<std::pair<double, double>> range = {}; // all points when absent; what lies outside is not drawn
  std::vector<std::string> categories = {};            // names of 0, 1, 2 ... instead of numbers, the first on top
};

/// One value and how far the truth may be from it.
struct PlotPoint {
  double x = 0, y = 0;
  std::optional<double> x_error = {}, y_error = {}; // half widths
};

enum class Drawn {
  points,
  small_points,
  line,
  line_with_points,
  dashed_line,
  dashed_steps // horizontal first, then vertical
};

struct Series {
  std::string name; // in the legend; empty: not there
  Drawn drawn = Drawn::points;
  int look = 0; // colour and mark: the same in all plots of a page for what is the same; negative: grey
  std::vector<PlotPoint> points;
};

/// A picture as plain data, drawn when a page is written. Texts are taken as they are.
struct Plot {
  std::string caption; // inline Markdown, below it
  PlotAxis x, y;
  std::vector<Series> series;
  int width = 560, height = 400; // pixels at the size of the page's text

  bool empty() const;
};

} // namespace studies
