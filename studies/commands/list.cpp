#include "studies/commands/commands.hpp"
#include "studies/commands/study_place.hpp"

#include "pfv/problem/error.hpp"
#include "reference/method.hpp"
#include "studies/document/table.hpp"
#include "studies/effect_cost/effect_study.hpp"
#include "studies/motion/experiment.hpp"
#include "studies/runner/study_file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace studies {

void add_list(CLI::App& app) {
  app.add_subcommand("list", "The studies there are")->callback([] {
    Table table{{{"study"}, {"cases", true}, {"title"}}, {}};
    for (const std::string& name : study_names()) {
      try {
        if (is_effect_study(study_file(name))) {
          const EffectStudy study = read_effect_study(study_file(name), false);
          table.rows.push_back({name, fmt::format("{}", study.effects.size()), study.title});
          continue;
        }
        const Study study = read_study(study_file(name));
        table.rows.push_back({name, fmt::format("{}", study.cases.size()), study.title});
      } catch (const pfv::InputError& error) {
        table.rows.push_back({name, "", fmt::format("cannot be read: {}", error.what())});
      }
    }
    for (const Experiment& experiment : experiments())
      table.rows.push_back({std::string(experiment.name), "", std::string(experiment.title)});
    fmt::print("{}", to_plain(table));
  });
}

void add_methods(CLI::App& app) {
  app.add_subcommand("methods", "The methods this build knows, and which can run here")->callback([] {
    Table table{{{"method"}, {"here"}, {"what it is"}}, {}};
    for (const auto& method : reference::methods()) {
      const auto reason = method->unavailable();
      table.rows.push_back(
          {method->name(), reason ? fmt::format("unavailable: {}", *reason) : "available", method->description()});
    }
    fmt::print("{}", to_plain(table));
  });
}

} // namespace studies
