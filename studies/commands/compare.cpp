#include "studies/commands/commands.hpp"
#include "studies/commands/conclude.hpp"
#include "studies/commands/study_place.hpp"

#include "pfv/problem/case.hpp"
#include "reference/method.hpp"
#include "studies/runner/progress.hpp"
#include "studies/runner/study_run.hpp"
#include "studies/runner/terminal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>

namespace studies {

namespace {

struct CompareOptions {
  std::filesystem::path file;
  std::optional<std::string> axis;
  std::vector<std::string> periodic;
  std::optional<double> scale;
  std::optional<std::string> box;
  std::vector<std::string> methods;
  std::vector<double> mesh_sizes{1.4, 1.0};
  std::string reference = "stokes_fem";
  RunSettings settings;
  bool json = false;
};

std::vector<std::string> wanted_methods(const CompareOptions& options) {
  std::vector<std::string> names = options.methods;
  if (names.empty())
    for (const auto& method : reference::methods())
      if (method->name() != "exact") // says nothing about the world
        names.push_back(method->name());
  for (const std::string& name : names)
    reference::find_method(name);
  if (std::ranges::find(names, options.reference) == names.end())
    names.push_back(options.reference);
  return names;
}

Study study_of(const CompareOptions& options, const pfv::Case& problem) {
  reference::find_method(options.reference);
  Study study;
  study.name = "compare";
  study.title = fmt::format("Comparison on {}", options.file.filename().string());
  study.question = "What does each method say about this one case, and do they agree?";
  study.reference = options.reference;
  std::vector<double> sizes = options.mesh_sizes;
  std::ranges::sort(sizes, std::ranges::greater{});
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  StudyCase one;
  one.id = "case";
  one.label = options.file.stem().string();
  one.toml = pfv::to_toml(problem);
  one.place = options.file.string();
  for (const std::string& name : wanted_methods(options)) {
    study.methods.push_back({name, sizes, sizes});
    one.methods.push_back(name);
  }
  study.cases.push_back(std::move(one));
  return study;
}

int compare_command(CompareOptions options) {
  pfv::QuestionOptions question;
  if (options.axis)
    question.axis = pfv::axis_named(*options.axis);
  if (!options.periodic.empty())
    question.periodic = pfv::axes_named(options.periodic);
  question.packing.scale = options.scale;
  if (options.box)
    question.packing.box = pfv::box_named(*options.box);
  const pfv::Case problem = pfv::read_question(options.file, question);
  for (const std::string& note : problem.notes)
    fmt::print(stderr, "{}\n", note);
  const Study study = study_of(options, problem);
  if (options.settings.work.root.empty())
    options.settings.work.root = studies_folder() / "compare" / "work" /
                                 fmt::format("{}-{}", options.file.stem().string(), pfv::digest(problem).substr(0, 8));
  std::vector<Row> rows;
  {
    Progress progress(std::cerr, terminal());
    rows = run_study(study, {}, options.settings, progress.onlooker());
  }
  conclude(study, {}, rows, options.settings.work.answers(), options.settings.work.root, options.json);
  return std::ranges::count(rows, Status::failed, &Row::status) > 0 ? 1 : 0;
}

} // namespace

void add_compare(CLI::App& app, Invocation& invocation) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand("compare", "Asks several methods about one case or packing");
  command->add_option("case", options->file, "Case (TOML) or packing (text, CSV, YADE export, LAMMPS dump, VTK)")
      ->required();
  command->add_option("--axis", options->axis, "Of the flow: x, y or z (the default of a packing)");
  command->add_option("--periodic", options->periodic, "Axes along which the box repeats: x,y,z or fewer")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--scale", options->scale,
                      "Length of one unit of the packing file, and of --box (m); 1 by default");
  command->add_option("--box", options->box, "Of the packing file, x0,y0,z0,x1,y1,z1; wins over the file's own");
  command->add_option("--methods", options->methods, "Which, a,b,...; all by default")->delimiter(',');
  command->add_option("--mesh-sizes", options->mesh_sizes, "Of the methods with a mesh; 1 is the default mesh")
      ->delimiter(',')
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--reference", options->reference, "Method the others are compared with")->capture_default_str();
  command->add_flag("--fresh", options->settings.fresh, "Forget what is stored and start over");
  command->add_flag("--retry-failed", options->settings.retry_failed, "Run again what failed before");
  command->add_flag("--json", options->json, "Results as JSON on standard output");
  command->add_option("--jobs", options->settings.jobs, "Runs at the same time; more than 1 disturbs the timings")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("--work", options->settings.work.root, "Work folder, by default studies/compare/work/...");
  command->callback([options, &invocation] {
    options->settings.study_executable = invocation.executable;
    invocation.exit_code = compare_command(*options);
  });
}

} // namespace studies
