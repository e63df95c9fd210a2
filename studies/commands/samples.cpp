#include "studies/commands/commands.hpp"
#include "studies/commands/study_place.hpp"

#include "pfv/problem/error.hpp"
#include "studies/runner/build_info.hpp"
#include "studies/runner/case_store.hpp"
#include "studies/runner/files.hpp"
#include "studies/runner/result.hpp"
#include "studies/runner/sample_tables.hpp"
#include "studies/runner/study_run.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace studies {

namespace {

struct SamplesOptions {
  std::string name, method;
  Scope scope;
  WorkFolder work;
  std::filesystem::path to;
};

void samples_command(SamplesOptions options) {
  const std::filesystem::path file = study_file(options.name);
  const Study study = read_study(file);
  if (!study.samples)
    throw pfv::InputError(fmt::format("{} has no samples: it lacks `samples = true`", file.string()));
  if (options.work.root.empty())
    options.work.root = file.parent_path() / "work";
  const std::string method = options.method.empty() ? study.reference : options.method;
  const std::vector<Row> rows = rows_of_plan(plan(study, options.scope), read_rows(options.work.rows()));
  SampleTables tables;
  std::size_t cases = 0;
  for (const Result& result : results(study, rows, options.work.answers()))
    if (const Finding& finding = result.finding; finding.method == method && finding.answered()) {
      const StudyCase& one = *std::ranges::find(study.cases, finding.case_id, &StudyCase::id);
      add_samples(store_case(one, options.work.cases(), digest_of_sources({"pfv/problem"})).problem, finding, tables);
      ++cases;
    }
  if (cases == 0)
    throw pfv::InputError(fmt::format("{} holds no answer of {}; `study run {}` makes them",
                                      options.work.rows().string(), method, options.name));
  const auto to = options.to.empty() ? file.parent_path() / "results" : options.to;
  write_file(to / "permeabilities.csv", SampleTables::permeabilities_head + tables.permeabilities);
  write_file(to / "forces.csv", SampleTables::forces_head + tables.forces);
  write_file(to / "pores.csv", SampleTables::pores_head + tables.pores);
  write_file(to / "throats.csv", SampleTables::throats_head + tables.throats);
  fmt::print("Samples of {} in {} cases: {}\n", method, cases, to.string());
}

} // namespace

void add_samples(CLI::App& app) {
  auto options = std::make_shared<SamplesOptions>();
  CLI::App* command = app.add_subcommand(
      "samples", "Writes what was found in every pore and throat and on every sphere as CSV; runs nothing");
  command->add_option("study", options->name, "Name of a study with samples, or a folder with its study.toml")
      ->required();
  command->add_option("--method", options->method, "Of this method, instead of the study's reference");
  command->add_flag("--quick", options->scope.quick, "Of the quick plan");
  command->add_option("--to", options->to, "Folder for the files, instead of the study's results");
  command->add_option("--work", options->work.root, "Work folder, instead of the study's own");
  command->callback([options] { samples_command(*options); });
}

} // namespace studies
