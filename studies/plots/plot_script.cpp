#include "studies/plots/plot_script.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace studies {

namespace {

constexpr std::array colours{"#2f7fc1", "#d9822b", "#2a9d62", "#c94f5c", "#8e6bbf",
                             "#1a9aa5", "#a0763e", "#c45ba3", "#7d8a2e"};
constexpr std::array marks{7, 5, 9, 11, 13, 6, 4, 8, 10}; // gnuplot's: disk, square, triangles, diamond, open ones
constexpr int legend_columns = 3;
constexpr const char* grey = "#808080";

using Range = std::pair<double, double>;

std::string quoted(const std::string& text) {
  std::string inside;
  for (const char c : text)
    inside += c == '\'' ? "''" : c == '\n' ? " " : std::string(1, c);
  return "'" + inside + "'";
}

/// 1, 2 or 5 times a power of ten.
double step_below(double value) {
  const double decade = std::pow(10, std::floor(std::log10(value)));
  return decade * (value >= 5 * decade ? 5 : value >= 2 * decade ? 2 : 1);
}

double step_above(double value) {
  const double below = step_below(value), digit = below / std::pow(10, std::floor(std::log10(below)));
  return below * (digit > 1.5 && digit < 3 ? 2.5 : 2);
}

bool within_two_decades(const Range& range) {
  return range.second / range.first <= 100;
}

/// Of the values along an axis: rounded to 1, 2, 5 or to decades when it is logarithmic, half a place beyond
/// categories, else theirs and a margin.
Range range_of(const PlotAxis& axis, std::vector<double> values) {
  if (axis.range)
    return *axis.range;
  if (!axis.categories.empty())
    return {-0.5, static_cast<double>(axis.categories.size()) - 0.5};
  std::erase_if(values, [&](double v) { return !std::isfinite(v) || (axis.scale == Scale::logarithmic && !(v > 0)); });
  if (values.empty())
    return {1, 10};
  const auto [least, most] = std::ranges::minmax(values);
  if (axis.scale == Scale::logarithmic) {
    if (const Range range{step_below(0.95 * least), step_above(1.05 * most)}; within_two_decades(range))
      return range;
    return {std::pow(10, std::floor(std::log10(0.95 * least))), std::pow(10, std::ceil(std::log10(1.05 * most)))};
  }
  const double margin = most > least ? 0.05 * (most - least) : std::max(std::abs(most), 1.0) * 0.05;
  return {least - margin, most + margin};
}

std::string axis_commands(char name, const PlotAxis& axis, const Range& range) {
  std::string text = fmt::format("set {}label {} noenhanced\n", name, quoted(axis.label));
  const bool downwards = name == 'y' && !axis.categories.empty();
  text += fmt::format("set {}range [{}:{}]\n", name, downwards ? range.second : range.first,
                      downwards ? range.first : range.second);
  if (axis.scale == Scale::logarithmic) {
    text += fmt::format("set logscale {}\n", name);
    if (within_two_decades(range)) {
      std::vector<std::string> tics;
      for (double tic = range.first; tic <= 1.001 * range.second; tic = step_above(1.001 * tic))
        tics.push_back(fmt::format("'{0:.6g}' {0}", tic));
      text += fmt::format("set {}tics ({})\n", name, fmt::join(tics, ", "));
    } else
      text += fmt::format("set format {} '10^{{%L}}'\n", name);
  }
  if (!axis.categories.empty()) {
    std::vector<std::string> tics;
    for (std::size_t i = 0; i < axis.categories.size(); ++i)
      tics.push_back(fmt::format("{} {}", quoted(axis.categories[i]), i));
    text += fmt::format("set {}tics ({}) noenhanced scale 0\n", name, fmt::join(tics, ", "));
  }
  return text;
}

bool fits(const PlotAxis& axis, const Range& range, double value) {
  return std::isfinite(value) && (axis.scale == Scale::linear || value > 0) && value >= range.first &&
         value <= range.second;
}

std::string style(Drawn drawn, int mark) {
  switch (drawn) {
  case Drawn::points:
    return fmt::format("points pt {} ps 0.8", mark);
  case Drawn::small_points:
    return fmt::format("points pt {} ps 0.35", mark);
  case Drawn::line:
    return "lines lw 2";
  case Drawn::line_with_points:
    return fmt::format("linespoints lw 1.5 pt {} ps 0.8", mark);
  case Drawn::dashed_line:
    return "lines lw 1.5 dt 2";
  case Drawn::dashed_steps:
    return "steps lw 1.5 dt 2";
  }
  return "";
}

} // namespace

std::string plot_script(const Plot& plot) {
  std::vector<double> xs, ys;
  for (const Series& series : plot.series)
    for (const PlotPoint& point : series.points) {
      const auto see = [](std::vector<double>& values, double value, const std::optional<double>& error, Scale scale) {
        values.push_back(value);
        if (error && scale == Scale::linear)
          values.insert(values.end(), {value - *error, value + *error});
      };
      see(xs, point.x, point.x_error, plot.x.scale);
      see(ys, point.y, point.y_error, plot.y.scale);
    }
  const Range x = range_of(plot.x, xs), y = range_of(plot.y, ys);
  // A legend under the whole picture: under the axes alone long names on the left would leave it no room.
  const auto names = std::ranges::count_if(plot.series, [](const Series& one) { return !one.name.empty(); });
  const double legend = std::ceil(static_cast<double>(names) / legend_columns);
  std::string text = fmt::format("set encoding utf8\nset terminal svg size {},{} font 'sans-serif,13'\n"
                                 "set output 'plot.svg'\nset border 3\nset tics nomirror\n"
                                 "set grid lc rgb '#a0a0a0' lw 0.5 dt 3\n"
                                 "set key at screen 0.5, screen 0.01 center bottom horizontal maxcols {} noenhanced "
                                 "samplen 2 Left reverse width 1\nset bmargin {}\n{}{}",
                                 plot.width, plot.height, legend_columns, 4 + 1.4 * legend,
                                 axis_commands('x', plot.x, x), axis_commands('y', plot.y, y));
  std::vector<std::string> drawn;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& series = plot.series[i];
    std::string points, bars;
    for (const PlotPoint& p : series.points) {
      if (!fits(plot.x, x, p.x) || !fits(plot.y, y, p.y))
        continue;
      points += fmt::format("{} {}\n", p.x, p.y);
      if (p.x_error) {
        const double low = std::max(p.x - *p.x_error, x.first);
        bars += fmt::format("{} {} {} 0\n", low, p.y, std::min(p.x + *p.x_error, x.second) - low);
      }
      if (p.y_error) {
        const double low = std::max(p.y - *p.y_error, y.first);
        bars += fmt::format("{} {} 0 {}\n", p.x, low, std::min(p.y + *p.y_error, y.second) - low);
      }
    }
    if (points.empty())
      continue;
    const auto look = static_cast<std::size_t>(std::max(series.look, 0));
    const std::string colour = fmt::format("lc rgb '{}'", series.look < 0 ? grey : colours[look % colours.size()]);
    const int mark = marks[look % marks.size()];
    text += fmt::format("$points{} << END\n{}END\n", i, points);
    if (!bars.empty()) {
      text += fmt::format("$bars{} << END\n{}END\n", i, bars);
      drawn.push_back(
          fmt::format("$bars{} using 1:2:3:4 with vectors heads size screen 0.006,90 lw 1.2 {} notitle", i, colour));
    }
    drawn.push_back(fmt::format("$points{} using 1:2 with {} {} {}", i, style(series.drawn, mark), colour,
                                series.name.empty() ? "notitle" : "title " + quoted(series.name)));
  }
  if (drawn.empty())
    drawn.emplace_back("NaN notitle"); // the empty axes
  return text + fmt::format("plot {}\n", fmt::join(drawn, ", \\\n     "));
}

} // namespace studies
