#include "studies/commands/effects.hpp"
#include "studies/commands/publish.hpp"

#include "pfv/problem/error.hpp"
#include "studies/effect_cost/effect_report.hpp"
#include "studies/effect_cost/run_effects.hpp"
#include "studies/runner/write_pages.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace studies {
namespace {

EffectStudy study_of(const std::filesystem::path& file, const Scope& scope) {
  if (!scope.methods.empty())
    throw pfv::InputError("--only names methods; a study of effects has none");
  return read_effect_study(file, scope.quick);
}

/// Writes and prints.
void conclude(const EffectStudy& study, const Scope& scope, const std::vector<Row>& rows, const WorkFolder& work,
              bool json) {
  const std::filesystem::path file =
      write_pages(effect_report(study, scope.quick, rows), work.root, readme_of(study.folder));
  if (json) {
    fmt::print("{}", effects_json(study, rows));
    return;
  }
  const auto costs = effect_costs(study, rows);
  fmt::print("\n{}\n\n{}", study.title, to_plain(effect_table(study, costs)));
  for (const EffectCost& cost : costs)
    if (!cost.trouble.empty())
      fmt::print("\nfailed: {}: {}\n", cost.id, cost.trouble);
  fmt::print("\nReport: {}\n", file.string());
}

} // namespace

int run_effects_command(const std::filesystem::path& study_file, const Scope& scope, const RunSettings& settings,
                        bool json) {
  const EffectStudy study = study_of(study_file, scope);
  fmt::print(stderr, "{}: {}\n", study.name, study.title);
  const std::vector<Row> rows =
      run_effects(study, settings, [](const std::string& line) { fmt::print(stderr, "  {}\n", line); });
  conclude(study, scope, rows, settings.work, json);
  return std::ranges::count(rows, Status::failed, &Row::status) > 0 ? 1 : 0;
}

void report_effects_command(const std::filesystem::path& study_file, const Scope& scope, const WorkFolder& work,
                            bool to_publish, bool json) {
  const EffectStudy study = study_of(study_file, scope);
  const std::vector<Row> rows = stored_effects(study, work);
  if (rows.empty())
    throw pfv::InputError(
        fmt::format("{} holds no row of this plan; `study run {}` makes them", work.rows().string(), study.name));
  conclude(study, scope, rows, work, json);
  if (to_publish)
    publish(effect_report(study, scope.quick, rows), rows, study.folder);
}

} // namespace studies
