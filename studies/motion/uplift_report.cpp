#include "studies/motion/uplift.hpp"
#include "studies/runner/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace studies {
namespace {

constexpr double tolerance = 0.05, balance_tolerance = 0.03;

/// The largest difference of floor and lift together from the weight, before the bed rises.
double imbalance(const Uplift& test) {
  double largest = 0;
  for (const UpliftMoment& moment : test.moments)
    if (moment.rise < 0.01)
      largest = std::max(largest, std::abs(moment.lift + moment.on_floor - 1));
  return largest;
}

Table findings(const Uplift& test) {
  const auto against = [&](double gradient) { return percent(gradient / test.critical - 1); };
  return {
      {{"quantity"}, {"value", true}, {"against i_c", true}},
      {{"grains", fmt::format("{}", test.bed.grains), ""},
       {"porosity n in the middle of the bed", fmt::format("{:.4f}", test.porosity), ""},
       {"i_c = (1 - n)(G_s - 1)", fmt::format("{:.4f}", test.critical), ""},
       {"i when the fluid carries the whole weight", fmt::format("{:.4f}", test.carried_at), against(test.carried_at)},
       {"i when the bed has risen by 0.01 diameters", fmt::format("{:.4f}", test.risen_at), against(test.risen_at)},
       {"largest |lift + floor - weight| / weight before", percent(imbalance(test)), ""}}};
}

std::string moments_csv(const Uplift& test) {
  std::string text = "gradient_over_critical,on_floor,lift,rise_in_diameters\n";
  for (const UpliftMoment& m : test.moments)
    text += fmt::format("{:.6f},{:.6f},{:.6f},{:.6f}\n", m.gradient / test.critical, m.on_floor, m.lift, m.rise);
  return text;
}

constexpr const char* figure = R"gnuplot(set xlabel "i / i_c"
set arrow from 1, graph 0 to 1, graph 1 nohead dt 2 lc rgb "#888888"
set ylabel "force / buoyant weight"
set yrange [0:1.2]
plot "moments.csv" skip 1 using 1:3 with points pt 7 ps 0.4 lc rgb "#1f5fa8" title "fluid", \
     "moments.csv" skip 1 using 1:2 with points pt 7 ps 0.4 lc rgb "#c0504d" title "floor"
set ylabel "rise of the bed / diameter"
set yrange [*:*]
plot "moments.csv" skip 1 using 1:4 with points pt 7 ps 0.4 lc rgb "#1f5fa8" notitle
)gnuplot";

constexpr const char* how_to_read =
    R"(A bed settled under its buoyant weight stands in a box that repeats sideways. The excess pressure below it is raised
from zero, slowly against the time in which the pressures of the bed even out. The gradient is that
of the pressures in the middle of the bed, from a fifth to four fifths of its height; so is the porosity. At the critical
gradient of Terzaghi the fluid carries the whole weight, nothing is left for the floor, and the bed comes loose.)";

} // namespace

ExperimentReport uplift_report(const Uplift& test) {
  const Expectation expectations[] = {
      within("gradient at which the fluid carries the whole weight, beyond the critical one",
             test.carried_at / test.critical - 1, tolerance),
      within("gradient at which the bed has risen, beyond the critical one", test.risen_at / test.critical - 1,
             tolerance),
      within("largest distance of lift and floor together from the weight before", imbalance(test), balance_tolerance)};
  ExperimentReport report;
  report.holds = all_hold(expectations);
  const Table table = findings(test);
  Document& page = report.page = page_of(uplift_experiment, expectations);
  page.add(Figure{"Forces and rise over the gradient", "figure.svg"});
  page.add(Paragraph{how_to_read});
  page.add(Paragraph{fmt::format("Both gradients are to be within {} of i_c, lift and floor together within {} of the "
                                 "weight.",
                                 percent(tolerance), percent(balance_tolerance))});
  page.add(table);
  page.add(Heading{"Cost"});
  page.add(Paragraph{fmt::format("{} steps", test.steps)});
  page.add(cost_table(test.stages, test.steps));
  page.add(Heading{"Where the numbers come from"});
  page.add(build_table());
  report.files = {{"moments.csv", moments_csv(test)}, {"figure.gp", figure_script(760, 360, 2, figure)}};
  report.summary = to_plain(table);
  return report;
}

} // namespace studies
