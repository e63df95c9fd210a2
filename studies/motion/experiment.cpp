#include "studies/motion/experiment.hpp"

#include "studies/motion/consolidation.hpp"
#include "studies/motion/immersed_settling.hpp"
#include "studies/motion/speed.hpp"
#include "studies/motion/stability/stability.hpp"
#include "studies/motion/uplift.hpp"
#include "studies/runner/build_info.hpp"
#include "studies/runner/files.hpp"
#include "studies/runner/now_utc.hpp"
#include "studies/runner/number_text.hpp"
#include "studies/runner/write_pages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>

namespace studies {

std::span<const Experiment> experiments() {
  static constexpr std::array all{consolidation_experiment, settling_experiment, speed_experiment, stability_experiment,
                                  uplift_experiment};
  return all;
}

const Experiment* experiment_named(std::string_view name) {
  const auto found = std::ranges::find(experiments(), name, &Experiment::name);
  return found == experiments().end() ? nullptr : &*found;
}

Expectation within(std::string what, double value, double bound) {
  return {std::move(what), percent(value), "within " + percent(bound), std::abs(value) <= bound};
}

bool all_hold(std::span<const Expectation> expectations) {
  return std::ranges::all_of(expectations, &Expectation::holds);
}

Document page_of(const Experiment& experiment, std::span<const Expectation> expectations) {
  Document page{std::string(experiment.title), {}};
  page.add(Paragraph{std::string(experiment.question)});
  const auto held = std::ranges::count_if(expectations, &Expectation::holds);
  page.add(Paragraph{fmt::format("{}{} of {} expectations hold.", outcome_lead, held, expectations.size())});
  List list;
  for (const Expectation& one : expectations)
    list.items.push_back(
        fmt::format("*{}*: {}: {}, to be {}.", one.holds ? "holds" : "does not hold", one.what, one.found, one.bound));
  page.add(list);
  return page;
}

std::filesystem::path write_report(const ExperimentReport& report, const std::filesystem::path& folder,
                                   const std::filesystem::path& readme) {
  std::filesystem::create_directories(folder);
  for (const auto& [name, text] : report.files)
    write_file(folder / name, text);
  for (const auto& [name, text] : report.files)
    if (name.ends_with(".gp")) {
      const std::string draw = fmt::format("cd '{}' && gnuplot '{}'", folder.string(), name);
      if (std::system("command -v gnuplot >/dev/null") != 0)
        fmt::print(stderr, "not drawn, as there is no gnuplot: {}\n", (folder / name).string());
      else if (std::system(draw.c_str()) != 0)
        fmt::print(stderr, "gnuplot could not draw {}\n", (folder / name).string());
    }
  return write_pages(report.page, folder, readme);
}

std::string figure_script(int width, int height, int plots, std::string_view commands) {
  return fmt::format("set terminal svg size {},{} font \"Helvetica,13\" background rgb \"white\"\n"
                     "set output \"figure.svg\"\nset datafile separator \",\"\nset multiplot layout 1,{}\n"
                     "set border 3\nset tics nomirror\nset bmargin 6\nset key at graph 0.5, graph -0.26 center top "
                     "maxcols 2 samplen 2\n{}",
                     width, height, plots, commands);
}

Table cost_table(std::span<const pfv::Stage> stages, std::size_t steps) {
  Table table{{{"stage"}, {"CPU seconds", true}, {"ms per step", true}}, {}};
  double all = 0;
  const auto add = [&](const std::string& name, double cpu) {
    table.rows.push_back({name, seconds(cpu), seconds(1e3 * cpu / static_cast<double>(steps))});
  };
  for (const pfv::Stage& stage : stages) {
    add(stage.name, stage.cpu_seconds);
    all += stage.cpu_seconds;
  }
  add("all", all);
  return table;
}

Table build_table() {
  const BuildInfo& build = build_info();
  return {{{"what"}, {"value"}},
          {{"commit", build.commit},
           {"compiler", build.compiler},
           {"flags", build.flags},
           {"machine", machine()},
           {"run (UTC)", now_utc()}}};
}

} // namespace studies
