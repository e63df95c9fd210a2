#include "studies/motion/speed.hpp"

#include "studies/runner/number_text.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace studies {
namespace {

/// Ratio of medians, with the least and the most over the turns.
struct Ratio {
  double median = 0, least = 0, most = 0;
};

Ratio ratio(const Turns& theirs, const Turns& ours) {
  Ratio result{theirs.median() / ours.median(), 1e300, 0};
  for (std::size_t turn = 0; turn < ours.cpu_seconds.size(); ++turn) {
    const double one = theirs.cpu_seconds[turn] / ours.cpu_seconds[turn];
    result.least = std::min(result.least, one);
    result.most = std::max(result.most, one);
  }
  return result;
}

std::string text_of(const Ratio& ratio) {
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", ratio.median, ratio.least, ratio.most);
}

std::string per_second(const Turns& turns) {
  return fmt::format("{:.4g}", 1 / turns.median());
}

Table dry_table(const std::vector<DrySpeed>& list) {
  Table table{{{"grains", true},
               {"contacts", true},
               {"springs"},
               {"step, s", true},
               {"steps / CPU s", true},
               {"LIGGGHTS", true},
               {"ratio", true},
               {"kinetic energies differ", true}},
              {}};
  for (const DrySpeed& one : list)
    table.rows.push_back({fmt::format("{}", one.grains), fmt::format("{}", one.contacts), std::string(one.law),
                          fmt::format("{:.3g}", one.step), per_second(one.ours),
                          one.theirs ? per_second(*one.theirs) : "unavailable",
                          one.theirs ? text_of(ratio(*one.theirs, one.ours)) : "",
                          one.theirs ? percent(one.our_energy / one.their_energy - 1) : ""});
  return table;
}

/// How the time of a step grows between two sizes under one law, as a power of the contacts.
Table growth_table(const std::vector<DrySpeed>& list) {
  Table table{{{"springs"}, {"from, ns per contact and step", true}, {"to", true}}, {}};
  for (const DrySpeed& small : list)
    for (const DrySpeed& large : list)
      if (large.law == small.law && large.grains > small.grains) {
        const auto each = [](const DrySpeed& one) {
          return fmt::format("{:.0f}", 1e9 * one.ours.median() / static_cast<double>(one.contacts));
        };
        table.rows.push_back({std::string(small.law), each(small), each(large)});
      }
  return table;
}

Table coupled_table(const CoupledSpeed& one) {
  Table table{{{"program"}, {"step, s", true}, {"steps / CPU s", true}, {"settlement, m", true}, {"ratio", true}}, {}};
  table.rows.push_back(
      {"ours", fmt::format("{:.3g}", one.step), per_second(one.ours), fmt::format("{:.4g}", one.settlement), ""});
  if (one.theirs)
    table.rows.push_back({"YADE " + one.version, fmt::format("{:.3g}", one.step), per_second(*one.theirs),
                          fmt::format("{:.4g}", one.their_settlement), text_of(ratio(*one.theirs, one.ours))});
  else
    table.rows.push_back({"YADE", "", "unavailable", "", ""});
  table.rows.push_back(
      {"ours, its own step", fmt::format("{:.3g}", one.our_step), per_second(one.at_our_step), "", ""});
  return table;
}

Table scheme_table(const SchemeSpeed& one) {
  const auto line = [](const char* scheme, const Course& course) {
    return std::vector<std::string>{scheme, fmt::format("{:.3g}", course.step), seconds(course.cpu_seconds),
                                    fmt::format("{:.4g}", course.settlement)};
  };
  return {{{"scheme"}, {"step, s", true}, {"CPU s", true}, {"settlement, m", true}},
          {line("explicit", one.lagging), line("semi-implicit", one.implicit)}};
}

Expectation at_least(std::string what, double reached, double bound) {
  return {std::move(what), fmt::format("{:.2f}", reached), fmt::format("at least {}", bound), reached >= bound};
}

/// Of what could be run here.
std::vector<Expectation> expectations_of(const Speed& speed) {
  std::vector<Expectation> list;
  std::optional<double> dry;
  for (const DrySpeed& one : speed.dry)
    if (one.theirs)
      dry = std::min(dry.value_or(1e300), ratio(*one.theirs, one.ours).median);
  if (dry)
    list.push_back(
        at_least("dry steps per CPU second over those of LIGGGHTS, the least of all", *dry, speed.bounds.dry));
  if (speed.coupled.theirs)
    list.push_back(at_least("steps of the coupled oedometer per CPU second over those of YADE",
                            ratio(*speed.coupled.theirs, speed.coupled.ours).median, speed.bounds.coupled));
  list.push_back(
      at_least("simulated time per CPU second, semi-implicit over explicit", speed.scheme.gain(), speed.bounds.scheme));
  return list;
}

constexpr const char* how_to_read = R"(
One thread each, turn by turn, so that a machine that slows down slows all; medians, and in brackets the least and the most
over the turns. Ratios above 1 are in our favour.

*Dry*: grains pressed together at 50 kPa between walls that then stay, with friction 0.5 at grains and walls. The springs
are the same in both programs, walls of the grains' material; those of Hertz have the same normal damping (0.015 of the
critical one). They differ in Mindlin's spring as its contact opens: our shear force is kept, theirs falls with the
stiffness. That both do the same shows in the kinetic energy of translation after the warm-up, a quarter of the steps. LIGGGHTS' time is that of its process with the
steps less that of one without; neighbours are kept with a skin of a tenth of a radius.

*Coupled*: the example of a consolidation that comes with YADE, in its units: a box of 1 m at 10 kPa under a piston, drained
above, then 1 kPa more; explicit, with its settings of FlowEngine (meshes anew after 200 steps at most, factors kept). Its
throats at walls conduct less and its piston has no mass, so that the two do not settle alike.

*Schemes*: the layer of the study `consolidation` from the moment of its load, in a fluid so viscous that it alone would allow a tenth of the step that contacts do.
)";

} // namespace

ExperimentReport speed_report(const Speed& speed) {
  const CoupledSpeed& coupled = speed.coupled;
  const std::vector<Expectation> expectations = expectations_of(speed);
  ExperimentReport report;
  report.holds = all_hold(expectations);
  Document& page = report.page = page_of(speed_experiment, expectations);
  page.add(Paragraph{how_to_read});
  page.add(Heading{"Dry grains"});
  page.add(dry_table(speed.dry));
  page.add(growth_table(speed.dry));
  page.add(Heading{fmt::format("Coupled oedometer, {} grains, {} pores", coupled.grains, coupled.pores)});
  page.add(coupled_table(coupled));
  page.add(Paragraph{fmt::format(
      "Ours at the common step: {} renewals of the pores in place, {} triangulations, {:.2f} iterations for a pressure "
      "field; by stage:",
      coupled.counts.refreshed, coupled.counts.rebuilt,
      static_cast<double>(coupled.counts.iterations) / static_cast<double>(coupled.counts.solves))});
  page.add(cost_table(coupled.stages, coupled.steps));
  page.add(Heading{
      fmt::format("Semi-implicit against explicit, {} grains, {} s", speed.scheme.grains, speed.scheme.duration)});
  page.add(scheme_table(speed.scheme));
  page.add(Heading{"Where the numbers come from"});
  page.add(build_table());
  report.summary = to_plain(dry_table(speed.dry)) + '\n' + to_plain(coupled_table(coupled)) + '\n' +
                   to_plain(scheme_table(speed.scheme));
  return report;
}

} // namespace studies
