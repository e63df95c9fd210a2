#include "studies/motion/stability/trial.hpp"

#include "meshing/child_process.hpp"
#include "pfv/problem/text.hpp"
#include "reference/temporary_folder.hpp"
#include "studies/runner/files.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace studies {
namespace {

using nlohmann::json;

// JSON has no infinity and no NaN: both come back as NaN, an absent bound as no bound.
double number_from(const json& value) {
  return value.is_number() ? value.get<double>() : std::nan("");
}

std::string text_of(const Measured& measured) {
  json list = json::array();
  for (const Measure& measure : measured.measures) {
    json one{{"what", measure.what}, {"value", measure.value}};
    if (std::isfinite(measure.least))
      one["least"] = measure.least;
    if (std::isfinite(measure.most))
      one["most"] = measure.most;
    list.push_back(one);
  }
  return json{{"measures", list}, {"remarks", measured.remarks}, {"plotted", measured.plotted}}.dump();
}

Measured measured_from(const std::string& text) {
  const json object = json::parse(text);
  Measured measured;
  measured.remarks = object.at("remarks");
  for (const json& one : object.at("measures"))
    measured.measures.push_back({one.at("what"), number_from(one.at("value")), one.value("least", -Measure::none),
                                 one.value("most", Measure::none)});
  for (const json& value : object.at("plotted"))
    measured.plotted.push_back(number_from(value));
  return measured;
}

} // namespace

bool TrialRow::holds() const {
  return outcome == done && std::ranges::all_of(ours.measures, &Measure::holds);
}

TrialRow tried(const Trial& trial, double wall_limit) {
  TrialRow row{trial.group, trial.name, done, {}, {}};
  const reference::TemporaryFolder folder("stability");
  const auto file = folder.path() / "measured.json", log = folder.path() / "log";
  const auto child = meshing::run_in_child(
      [&] {
        write_file(file, text_of(trial.ours()));
        return 0;
      },
      {.log = log, .wall_limit = wall_limit});
  row.cpu_seconds = child.cpu_seconds;
  if (child.succeeded())
    row.ours = measured_from(pfv::read_text(file));
  else
    row.outcome = child.how_it_ended() + (child.exit_code == 1 ? ": " + meshing::last_lines(log, 1) : "");
  if (trial.theirs)
    row.theirs = trial.theirs();
  return row;
}

} // namespace studies
