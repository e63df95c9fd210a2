#include "studies/commands/commands.hpp"
#include "studies/commands/conclude.hpp"
#include "studies/commands/effects.hpp"
#include "studies/commands/experiment.hpp"
#include "studies/commands/publish.hpp"
#include "studies/commands/study_place.hpp"

#include "pfv/problem/error.hpp"
#include "studies/effect_cost/effect_study.hpp"
#include "studies/places/places.hpp"
#include "studies/runner/report.hpp"
#include "studies/runner/study_run.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace studies {

namespace {

struct ReportOptions {
  std::string name;
  Scope scope;
  WorkFolder work;
  bool publish = false;
  bool json = false;
};

void report_command(ReportOptions options) {
  if (const Experiment* experiment = experiment_named(options.name)) {
    report_experiment(*experiment, options.publish, options.work.root);
    return;
  }
  const std::filesystem::path file = study_file(options.name);
  if (options.work.root.empty())
    options.work.root = file.parent_path() / "work";
  if (is_effect_study(file))
    return report_effects_command(file, options.scope, options.work, options.publish, options.json);
  const Study study = read_study(file);
  const std::vector<Row> rows = rows_of_plan(plan(study, options.scope), read_rows(options.work.rows()));
  if (rows.empty())
    throw pfv::InputError(fmt::format("{} holds no row of this plan; `study run {}` makes them",
                                      options.work.rows().string(), options.name));
  conclude(study, options.scope, rows, options.work.answers(), options.work.root, options.json);
  if (options.publish)
    publish(report(study, options.scope, rows, options.work.answers()), rows, study.folder,
            place_files(study, results(study, rows, options.work.answers())));
}

} // namespace

void add_report(CLI::App& app) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* command = app.add_subcommand("report", "Reports from what is stored; runs nothing");
  command->add_option("study", options->name, "Name of a study, or a folder with a study.toml")->required();
  command->add_flag("--quick", options->scope.quick, "Of the quick plan");
  command->add_option("--only", options->scope.methods, "Only this method, or these: a,b")->delimiter(',');
  command->add_flag("--publish", options->publish, "Also put report and rows into the study's results folder");
  command->add_flag("--json", options->json, "Results as JSON on standard output");
  command->add_option("--work", options->work.root, "Work folder, instead of the study's own");
  command->callback([options] { report_command(*options); });
}

} // namespace studies
