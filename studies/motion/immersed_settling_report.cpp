#include "studies/motion/immersed_settling.hpp"
#include "studies/runner/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace studies {
namespace {

constexpr double carried_tolerance = 0.05, rest_tolerance = 0.02;

/// The largest share of the weight that the excess pressure at the floor reaches.
double highest_pressure(const Settling& test) {
  return std::ranges::max(test.moments, {}, &SettlingMoment::floor_pressure).floor_pressure;
}

/// Root mean square of what fluid and floor together miss of the weight, after the start from rest.
double imbalance(const Settling& test) {
  double sum = 0, count = 0;
  for (std::size_t n = test.moments.size() / 50; n < test.moments.size(); ++n, ++count)
    sum += std::pow(test.moments[n].lift + test.moments[n].on_floor - 1, 2);
  return std::sqrt(sum / count);
}

/// Mean speed while the suspension still is one: until it has sunk by a twentieth.
double first_speed(const Settling& test) {
  double sum = 0, count = 0;
  for (std::size_t n = 1; n < test.moments.size() && test.moments[n].mean_height > 0.95; ++n, ++count)
    sum += test.moments[n].speed;
  return count > 0 ? sum / count : 0;
}

Table findings(const Settling& test) {
  const SettlingMoment& last = test.moments.back();
  return {{{"quantity"}, {"value", true}},
          {{"grains", fmt::format("{}", test.bed.grains)},
           {"solid fraction of the suspension", fmt::format("{:.2f}", test.solid_fraction)},
           {"viscosity", fmt::format("{:.3g} Pa s", test.bed.viscosity)},
           {"highest excess pressure at the floor × area / weight", fmt::format("{:.4f}", highest_pressure(test))},
           {"(lift + floor) / weight - 1, root mean square", percent(imbalance(test))},
           {"at the end: floor / weight", fmt::format("{:.5f}", last.on_floor)},
           {"at the end: excess pressure × area / weight", fmt::format("{:.5f}", last.floor_pressure)},
           {"porosity of the bed", fmt::format("{:.4f}", test.bed_porosity)},
           {"speed at the start", fmt::format("{:.3g} m/s", first_speed(test))},
           {"k (1 - n)(ρ_s - ρ_f) g / μ, grains held as they were", fmt::format("{:.3g} m/s", test.expected_speed)}}};
}

std::string moments_csv(const Settling& test) {
  std::string text = "time,floor_pressure,on_floor,lift,mean_height,speed\n";
  for (const SettlingMoment& m : test.moments)
    text += fmt::format("{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6e}\n", m.time, m.floor_pressure, m.on_floor, m.lift,
                        m.mean_height, m.speed);
  return text;
}

constexpr const char* figure = R"gnuplot(set xlabel "time (s)"
set ylabel "force / buoyant weight"
set yrange [0:1.2]
plot "moments.csv" skip 1 using 1:2 with lines lw 2 lc rgb "#1f5fa8" title "excess pressure", \
     "moments.csv" skip 1 using 1:3 with lines lw 2 lc rgb "#c0504d" title "floor", \
     "moments.csv" skip 1 using 1:($3+$4) with lines lw 1 lc rgb "#888888" title "together"
set ylabel "mean height / that at the start"
set yrange [0.5:1]
plot "moments.csv" skip 1 using 1:5 with lines lw 2 lc rgb "#1f5fa8" notitle
)gnuplot";

} // namespace

ExperimentReport settling_report(const Settling& test) {
  const SettlingMoment& last = test.moments.back();
  const Expectation expectations[] = {
      within("distance of the highest excess pressure at the floor from the weight", highest_pressure(test) - 1,
             carried_tolerance),
      within("what lift and floor together miss of the weight, root mean square", imbalance(test), carried_tolerance),
      within("at rest, what the floor misses of the weight", last.on_floor - 1, rest_tolerance),
      within("at rest, the excess pressure that is left, of the weight", last.floor_pressure, rest_tolerance)};
  ExperimentReport report;
  report.holds = all_hold(expectations);
  const Table table = findings(test);
  Document& page = report.page = page_of(settling_experiment, expectations);
  page.add(Figure{"Who carries the weight, and the mean height", "figure.svg"});
  page.add(Paragraph{
      "A suspension without contacts rests on the fluid: the excess pressure at the floor reaches the buoyant weight "
      "per "
      "area. As a bed grows from below, contacts take over, and at rest the pressure is gone. What both carry together "
      "differs from the weight only while grains gather or lose speed. Pore-scale finite volumes are a model of dense "
      "packings: the balance of forces does not depend on that, the speed at the start does, and so does the "
      "permeability it is held against."});
  page.add(
      Paragraph{fmt::format("The pressure is to come within {} of the weight, both together too (root mean square), "
                            "and to rest within {}.",
                            percent(carried_tolerance), percent(rest_tolerance))});
  page.add(table);
  page.add(Heading{"Cost"});
  page.add(Paragraph{fmt::format("{} steps, triangulated {} times", test.steps, test.rebuilt)});
  page.add(cost_table(test.stages, test.steps));
  page.add(Heading{"Where the numbers come from"});
  page.add(build_table());
  report.files = {{"moments.csv", moments_csv(test)}, {"figure.gp", figure_script(760, 360, 2, figure)}};
  report.summary = to_plain(table);
  return report;
}

} // namespace studies
