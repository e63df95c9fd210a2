#include "studies/commands/commands.hpp"
#include "studies/commands/conclude.hpp"
#include "studies/commands/effects.hpp"
#include "studies/commands/experiment.hpp"
#include "studies/commands/study_place.hpp"

#include "pfv/problem/error.hpp"
#include "studies/document/table.hpp"
#include "studies/effect_cost/effect_study.hpp"
#include "studies/motion/experiment.hpp"
#include "studies/runner/progress.hpp"
#include "studies/runner/study_run.hpp"
#include "studies/runner/terminal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>

namespace studies {

namespace {

struct RunOptions {
  std::string name;
  Scope scope;
  RunSettings settings;
  std::optional<double> cpu_budget;
  std::optional<double> memory_budget;
  bool json = false;
};

bool is_fault(const Study& study, const Row& row) {
  const auto method = std::ranges::find(study.methods, row.method, &StudyMethod::name);
  return row.status == Status::failed && (method == study.methods.end() || !method->may_fail);
}

int run_one(RunOptions options) {
  if (const Experiment* experiment = experiment_named(options.name)) {
    if (!options.scope.methods.empty() || options.settings.retry_failed || options.json || options.cpu_budget ||
        options.memory_budget || options.settings.jobs != RunSettings{}.jobs)
      throw pfv::InputError(fmt::format("{} is one simulation: it takes --quick and --work only", options.name));
    return run_experiment(*experiment, options.scope.quick, options.settings.work.root);
  }
  const std::filesystem::path file = study_file(options.name);
  WorkFolder& work = options.settings.work;
  if (work.root.empty())
    work.root = file.parent_path() / "work";
  if (is_effect_study(file))
    return run_effects_command(file, options.scope, options.settings, options.json);
  Study study = read_study(file);
  for (StudyCase& one : study.cases) {
    one.budget.cpu_seconds = options.cpu_budget.value_or(one.budget.cpu_seconds);
    one.budget.memory_bytes = options.memory_budget.value_or(one.budget.memory_bytes);
  }

  fmt::print(stderr, "{}: {}\n", study.name, study.title);
  std::vector<Row> rows;
  {
    Progress progress(std::cerr, terminal());
    rows = run_study(study, options.scope, options.settings, progress.onlooker());
  }
  conclude(study, options.scope, rows, work.answers(), work.root, options.json);
  return std::ranges::any_of(rows, [&](const Row& row) { return is_fault(study, row); }) ? 1 : 0;
}

/// One after the other, each in its own work folder. One that cannot be run does not keep the others from it.
int run_all(const RunOptions& options) {
  if (!options.scope.methods.empty() || options.json || !options.settings.work.root.empty())
    throw pfv::InputError("all studies take no --only, --json and --work, which are for one");
  Table table{{{"study"}, {"ended"}, {"wall s", true}}, {}};
  bool all_well = true;
  for (const std::string& name : all_names()) {
    RunOptions one = options;
    if (experiment_named(name)) {
      one = {};
      one.scope.quick = options.scope.quick;
    }
    one.name = name;
    const auto start = std::chrono::steady_clock::now();
    std::string ended = "well";
    try {
      if (run_one(one) != 0)
        ended = "with a failure";
    } catch (const std::exception& error) {
      ended = error.what();
    }
    all_well = all_well && ended == "well";
    const std::chrono::duration<double> past = std::chrono::steady_clock::now() - start;
    table.rows.push_back({name, ended, fmt::format("{:.0f}", past.count())});
  }
  fmt::print("\n{}", to_plain(table));
  return all_well ? 0 : 1;
}

} // namespace

void add_run(CLI::App& app, Invocation& invocation) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "Does what a study plans and has not stored yet, then reports");
  command->add_option("study", options->name, "Name of a study, a folder with a study.toml, or all")->required();
  command->add_flag("--quick", options->scope.quick, "Only the quick cases, on coarser meshes");
  command->add_option("--only", options->scope.methods, "Only this method, or these: a,b")->delimiter(',');
  command->add_flag("--fresh", options->settings.fresh, "Forget what is stored and start over");
  command->add_flag("--retry-failed", options->settings.retry_failed, "Run again what failed before");
  command->add_flag("--json", options->json, "Results as JSON on standard output");
  command->add_option("--jobs", options->settings.jobs, "Runs at the same time; more than 1 disturbs the timings")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("--cpu-budget", options->cpu_budget, "CPU seconds a run of any case may be expected to take");
  command->add_option("--memory-budget", options->memory_budget, "Bytes a run of any case may be expected to take");
  command->add_option("--work", options->settings.work.root, "Work folder, instead of the study's own");
  command->callback([options, &invocation] {
    options->settings.study_executable = invocation.executable;
    invocation.exit_code = options->name == "all" ? run_all(*options) : run_one(*options);
  });
}

} // namespace studies
