#include "studies/motion/consolidation.hpp"
#include "studies/motion/terzaghi.hpp"
#include "studies/runner/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace studies {
namespace {

constexpr double settlement_tolerance = 0.03, pressure_tolerance = 0.05;
constexpr double profile_times[] = {0.05, 0.25, 0.5, 0.75};

Table layer_table(const Layer& layer, const Oedometer& asked) {
  const auto row = [](const char* what, std::string value, const char* how) {
    return std::vector<std::string>{what, std::move(value), how};
  };
  return {
      {{"quantity"}, {"value", true}, {"measured by"}},
      {row("grains", fmt::format("{}", asked.grains), ""),
       row("height", fmt::format("{:.5f} m", layer.height), "compaction to the confining stress"),
       row("confining stress, load", fmt::format("{:.3g}, {:.3g} kPa", asked.confining_stress / 1e3, asked.load / 1e3),
           ""),
       row("porosity", fmt::format("{:.4f}", layer.porosity), "its pores"),
       row("drained planes", fmt::format("{:.4f}, {:.4f} H", layer.lower, layer.upper),
           "permeability test: where the line of pressures of the middle meets the imposed ones"),
       row("k", fmt::format("{:.4g} m²", layer.permeability), "permeability test: flux over the gradient of that line"),
       row("k of the box", fmt::format("{:.4g} m²", layer.permeability_of_box),
           "the same over the drop and the height"),
       row("S, final settlement", fmt::format("{:.4g} m", layer.final_settlement), "slow dry step of the load"),
       row("share of the ends", percent(layer.share_of_ends),
           "that step: change of volume in pores held at a drained wall's pressure"),
       row("m_v", fmt::format("{:.4g} 1/Pa", layer.compressibility), "(1 - share) S / (load × drained length)"),
       row("S(load/2) / (S/2) - 1", percent(layer.nonlinearity), "that step, at half of the load"),
       row("viscosity", fmt::format("{:.4g} Pa s", layer.viscosity), "chosen: T = 1 after the duration"),
       row("c_v = k / (μ m_v)", fmt::format("{:.4g} m²/s", layer.consolidation()), "")}};
}

Table moment_table(const Consolidation& test) {
  Table table{{{"T", true},
               {"S/S_final", true},
               {"Terzaghi", true},
               {"difference", true},
               {"middle p/load", true},
               {"Terzaghi", true},
               {"difference", true}},
              {}};
  for (const Moment& moment : test.moments) {
    const double s = expected_settlement(test.layer, moment.time_factor);
    const double p = expected_pressure(test.layer, moment.time_factor, 0.5);
    table.rows.push_back({fmt::format("{:.3f}", moment.time_factor), fmt::format("{:.4f}", moment.settlement),
                          fmt::format("{:.4f}", s), percent(moment.settlement - s),
                          fmt::format("{:.4f}", moment.middle_pressure), fmt::format("{:.4f}", p),
                          percent(moment.middle_pressure - p)});
  }
  return table;
}

/// A row for each layer: the errors over 0.05 ≤ T ≤ 1.
Table error_table(const ConsolidationError& error, const Oedometer& asked, std::span<const OtherLayer> others) {
  Table table{{{"packing of seed"},
               {"settlement, of the final one: largest", true},
               {"root mean square", true},
               {"pressure at half of the height, of the load: largest", true},
               {"root mean square", true}},
              {}};
  const auto add = [&](unsigned seed, const ConsolidationError& of) {
    table.rows.push_back({fmt::format("{}", seed), percent(of.largest_settlement), percent(of.rms_settlement),
                          percent(of.largest_pressure), percent(of.rms_pressure)});
  };
  add(asked.seed, error);
  for (const OtherLayer& other : others)
    add(other.seed, other.error);
  return table;
}

std::string moments_csv(const Consolidation& test) {
  std::string text = "time_factor,settlement,terzaghi_settlement,middle_pressure,terzaghi_middle_pressure\n";
  for (const Moment& m : test.moments)
    text += fmt::format("{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n", m.time_factor, m.settlement,
                        expected_settlement(test.layer, m.time_factor), m.middle_pressure,
                        expected_pressure(test.layer, m.time_factor, 0.5));
  return text;
}

std::string profiles_csv(const Consolidation& test) {
  std::string text = "time_factor,height,pressure,terzaghi_pressure\n";
  for (const double wanted : profile_times)
    for (const Moment& m : test.moments)
      if (std::abs(m.time_factor - wanted) < 0.005)
        for (std::size_t s = 0; s < m.pressure.size(); ++s) {
          const double z = (static_cast<double>(s) + 0.5) / static_cast<double>(m.pressure.size());
          text += fmt::format("{:.2f},{:.4f},{:.6f},{:.6f}\n", wanted, z, m.pressure[s],
                              expected_pressure(test.layer, m.time_factor, z));
        }
  return text;
}

std::string curves_csv(const Layer& layer) {
  std::string text = "time_factor,settlement,middle_pressure\n";
  for (int k = 1; k <= 200; ++k) {
    const double t = 0.005 * k;
    text += fmt::format("{:.4f},{:.6f},{:.6f}\n", t, expected_settlement(layer, t), expected_pressure(layer, t, 0.5));
  }
  return text;
}

/// Figure 6 of the paper: pressure in time, pressure over the height at four times, settlement in time.
constexpr const char* figure = R"gnuplot(set xlabel "time factor T"
set ylabel "pressure at half of the height / load"
set xrange [0:1]
set yrange [0:1.1]
plot "curves.csv" skip 1 using 1:3 with lines lw 2 lc rgb "#888888" title "Terzaghi", \
     "moments.csv" skip 1 using 1:4 with points pt 7 ps 0.6 lc rgb "#1f5fa8" title "PFV-DEM"
set xlabel "pressure / load"
set ylabel "height / H"
set xrange [0:1.1]
set yrange [0:1]
plot for [i=0:3] "profiles.csv" skip 1 using ($1==word("0.05 0.25 0.50 0.75",i+1)?$4:1/0):2 with lines lw 2 lc rgb "#888888" notitle, \
     for [i=0:3] "profiles.csv" skip 1 using ($1==word("0.05 0.25 0.50 0.75",i+1)?$3:1/0):2 with points pt 7 ps 0.6 lc i+1 title "T = ".word("0.05 0.25 0.50 0.75",i+1)
set xlabel "time factor T"
set ylabel "settlement / final settlement"
set xrange [0:1]
set yrange [1:0]
plot "curves.csv" skip 1 using 1:2 with lines lw 2 lc rgb "#888888" title "Terzaghi", \
     "moments.csv" skip 1 using 1:2 with points pt 7 ps 0.6 lc rgb "#1f5fa8" title "PFV-DEM"
)gnuplot";

constexpr const char* how_to_read =
    R"(Grains compacted at low friction and then given the friction of the test are elastic in a small step of load, and the box
repeats sideways, so that the layer is what Terzaghi's theory supposes. The load is put on the piston at once; until T is
some 0.04 the piston still comes to rest. The fluid is far more viscous than water, which between millimetres of sand
would be inertial instead.)";

constexpr const char* no_fit =
    R"(No constant is fitted. Pores at a drained wall have its pressure, so the drained planes are not the walls: where they are,
which share of the settlement lies in those pores and so comes at once, k and m_v are measured on the same layer before
the test, and T = 4 c_v t / L² with L the distance between the planes.)";

} // namespace

ExperimentReport consolidation_report(const Consolidation& test, const Oedometer& asked,
                                      std::span<const OtherLayer> others) {
  const ConsolidationError error = error_of(test);
  ConsolidationError worst = error;
  for (const OtherLayer& other : others) {
    worst.largest_settlement = std::max(worst.largest_settlement, other.error.largest_settlement);
    worst.largest_pressure = std::max(worst.largest_pressure, other.error.largest_pressure);
  }
  const std::string of = others.empty() ? "" : ", the worst layer";
  const Expectation expectations[] = {
      within("largest error of the settlement, of the final one" + of, worst.largest_settlement, settlement_tolerance),
      within("largest error of the pressure at half of the height, of the load" + of, worst.largest_pressure,
             pressure_tolerance)};
  ExperimentReport report;
  report.holds = all_hold(expectations);
  Document& page = report.page = page_of(consolidation_experiment, expectations);
  page.add(Figure{"Pressure, profiles and settlement", "figure.svg"});
  page.add(Paragraph{"Points: the simulation; lines: Terzaghi."});
  page.add(Paragraph{how_to_read});
  page.add(Paragraph{no_fit});
  page.add(Heading{"Error"});
  page.add(
      Paragraph{fmt::format("Over 0.05 ≤ T ≤ 1; to be within {} and {}. The packings differ by their seed, all else on "
                            "this page is of the first.",
                            percent(settlement_tolerance), percent(pressure_tolerance))});
  const Table errors = error_table(error, asked, others);
  page.add(errors);
  page.add(Heading{"The layer"});
  page.add(layer_table(test.layer, asked));
  page.add(Heading{"In time"});
  page.add(moment_table(test));
  page.add(Heading{"Cost"});
  page.add(
      Paragraph{fmt::format("{} steps of {:.3g} s, {:.2g} of the contacts' limit; the energy balance misses {:.1e} "
                            "of the work of the load.",
                            test.steps, test.step, test.step / test.contact_limit, test.energy_error)});
  page.add(cost_table(test.stages, test.steps));
  page.add(Heading{"Where the numbers come from"});
  page.add(build_table());
  report.files = {{"moments.csv", moments_csv(test)},
                  {"profiles.csv", profiles_csv(test)},
                  {"curves.csv", curves_csv(test.layer)},
                  {"figure.gp", figure_script(1080, 380, 3, figure)}};
  report.summary = to_plain(layer_table(test.layer, asked)) + '\n' + to_plain(errors);
  return report;
}

} // namespace studies
