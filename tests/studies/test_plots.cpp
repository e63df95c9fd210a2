#include "studies/plots/draw.hpp"
#include "studies/plots/plot_script.hpp"
#include "studies/plots/svg_for_pages.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace studies {
namespace {

Plot example_plot() {
  return {"A caption",
          {"CPU's seconds", Scale::logarithmic},
          {"error_of <k> & more"},
          {{"pore_volumes", Drawn::points, 0, {{1e-3, 2, {}, 1.5}, {10, 3}, {0, 4}, {std::nan(""), 1}}},
           {"", Drawn::dashed_line, -1, {{1e-3, 2}, {10, 3}}}}};
}

double luminance(const std::string& colour) {
  double sum = 0;
  for (const auto& [at, weight] : {std::pair{1, 0.2126}, {3, 0.7152}, {5, 0.0722}}) {
    const double value = std::stoi(colour.substr(static_cast<std::size_t>(at), 2), nullptr, 16) / 255.0;
    sum += weight * (value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4));
  }
  return sum;
}

TEST(PlotScript, LeavesOutWhatALogarithmicAxisCannotShow) {
  const std::string script = plot_script(example_plot());
  EXPECT_NE(script.find("$points0 << END\n0.001 2\n10 3\nEND\n"), script.npos) << script;
  EXPECT_NE(script.find("$bars0 << END\n0.001 0.5 0 3\n"), script.npos) << script;
  EXPECT_NE(script.find("set xlabel 'CPU''s seconds'"), script.npos);
  EXPECT_NE(script.find("set xrange [0.0001:100]"), script.npos) << script;
}

TEST(PlotScript, EndsABarThatReachesZeroAtTheEdge) {
  Plot plot = example_plot();
  plot.y.scale = Scale::logarithmic;
  plot.series[0].points[0].y_error = 3;
  EXPECT_NE(plot_script(plot).find("$bars0 << END\n0.001 0.5 0 4.5\n"), std::string::npos) << plot_script(plot);
}

TEST(PlotScript, PutsCategoriesOnLinesFromTheTop) {
  Plot plot = example_plot();
  plot.y = {"", Scale::linear, {}, {"one", "two's"}};
  const std::string script = plot_script(plot);
  EXPECT_NE(script.find("set yrange [1.5:-0.5]"), script.npos);
  EXPECT_NE(script.find("set ytics ('one' 0, 'two''s' 1)"), script.npos);
}

TEST(SvgForPages, ReadsOnLightAndDark) {
  for (const auto& [r, g, b] :
       {std::tuple{255, 255, 0}, {0, 0, 255}, {31, 95, 168}, {250, 250, 250}, {148, 0, 211}, {10, 10, 10}}) {
    const double of_paper = luminance(readable_on_both(r, g, b));
    EXPECT_GE(1.05 / (of_paper + 0.05), 2.95);
    EXPECT_GE((of_paper + 0.05) / (luminance("#15181c") + 0.05), 2.95);
  }
  EXPECT_EQ(readable_on_both(128, 128, 128), "#808080");
}

TEST(SvgForPages, HasIdsOfItsOwnAndTheColourOfTheText) {
  const std::string svg =
      svg_for_pages("<?xml version=\"1.0\"?>\n<svg \n width=\"60\" height=\"40\"\n viewBox=\"0 0 60 40\"\n "
                    "xmlns=\"http://www.w3.org/2000/svg\"\n"
                    ">\n<title>Gnuplot</title><rect x=\"0\" fill=\"#ffffff\"/><circle id='a' r='1'/>"
                    "<use xlink:href='#a' color='rgb(  0,   0, 255)'/><path stroke='black'/><text "
                    "font-family=\"Helvetica\">x</text></svg>",
                    "f7-");
  EXPECT_TRUE(svg.starts_with("<svg role=\"img\" style=\"width:60px\"")) << svg;
  EXPECT_NE(svg.find("id='f7-a'"), svg.npos);
  EXPECT_NE(svg.find("<use href='#f7-a'"), svg.npos);
  EXPECT_NE(svg.find("stroke='currentColor'"), svg.npos);
  for (const char* gone : {"http", "Gnuplot", "#ffffff", "Helvetica", "rgb(", "black"})
    EXPECT_EQ(svg.find(gone), svg.npos) << gone;
  EXPECT_EQ(svg_for_pages("not a picture", "f"), "");
}

TEST(Draw, DrawsOrSaysWhyNot) {
  const Drawing drawing = draw(example_plot(), "f1-");
  if (drawing.why_not == "there is no gnuplot here to draw it")
    GTEST_SKIP() << drawing.why_not;
  EXPECT_EQ(drawing.why_not, "");
  EXPECT_TRUE(drawing.svg.starts_with("<svg"));
  EXPECT_NE(drawing.svg.find(">pore_volumes<"), std::string::npos);
  EXPECT_NE(drawing.svg.find("error_of &lt;k> &amp; more"), std::string::npos);
}

TEST(Draw, WithoutGnuplotSaysSo) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  const Drawing drawing = draw(example_plot(), "f1-");
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(drawing.svg, "");
  EXPECT_EQ(drawing.why_not, "there is no gnuplot here to draw it");
}

} // namespace
} // namespace studies
