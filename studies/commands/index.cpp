#include "studies/commands/commands.hpp"
#include "studies/commands/study_place.hpp"

#include "pfv/problem/error.hpp"
#include "studies/document/html.hpp"
#include "studies/effect_cost/effect_study.hpp"
#include "studies/motion/experiment.hpp"
#include "studies/runner/files.hpp"
#include "studies/runner/index_page.hpp"
#include "studies/runner/study_file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace studies {

namespace {

struct IndexOptions {
  std::filesystem::path to;
  bool work = false;
};

std::string title_of(const std::string& name) {
  const auto file = study_file(name);
  try {
    return is_effect_study(file) ? read_effect_study(file, false).title : read_study(file).title;
  } catch (const pfv::InputError& error) {
    return fmt::format("cannot be read: {}", error.what());
  }
}

void index_command(const IndexOptions& options) {
  const auto folder_of = [&](std::string_view name) {
    return studies_folder() / name / (options.work ? "work" : "results");
  };
  std::vector<IndexEntry> entries;
  for (const std::string& name : study_names())
    entries.push_back({name, title_of(name), folder_of(name)});
  for (const Experiment& experiment : experiments())
    entries.push_back({std::string(experiment.name), std::string(experiment.title), folder_of(experiment.name)});
  std::ranges::sort(entries, {}, &IndexEntry::name);
  const auto to = options.to.empty() ? studies_folder() : options.to;
  write_file(to / "index.html", to_html(index_page(entries, to)));
  fmt::print("Index: {}\n", (to / "index.html").string());
}

} // namespace

void add_index(CLI::App& app) {
  auto options = std::make_shared<IndexOptions>();
  CLI::App* command =
      app.add_subcommand("index", "Writes index.html, which leads to the published report of every study");
  command->add_flag("--work", options->work, "To the reports in the work folders instead");
  command->add_option("--to", options->to, "Folder for it, instead of that of the studies");
  command->callback([options] { index_command(*options); });
}

} // namespace studies
