#include "studies/commands/conclude.hpp"
#include "studies/commands/publish.hpp"

#include "studies/runner/report.hpp"
#include "studies/runner/result_table.hpp"
#include "studies/runner/scaling.hpp"
#include "studies/runner/terminal.hpp"
#include "studies/runner/write_pages.hpp"

#include <fmt/color.h>
#include <fmt/format.h>

namespace studies {

namespace {

fmt::text_style bold_if(bool colours) {
  return colours ? fmt::text_style(fmt::emphasis::bold) : fmt::text_style();
}

} // namespace

void conclude(const Study& study, const Scope& scope, const std::vector<Row>& rows,
              const std::filesystem::path& answers, const std::filesystem::path& folder, bool json) {
  const std::filesystem::path file = write_pages(report(study, scope, rows, answers), folder, readme_of(study.folder));
  const std::vector<Result> list = results(study, rows, answers);
  if (json) {
    fmt::print("{}", results_json(study, list));
    return;
  }
  fmt::print("\n");
  fmt::print(bold_if(terminal().colours), "{}", study.title);
  fmt::print("\n\n{}", to_plain(result_table(study, list)));
  for (const auto& [name, table] : scaling_tables(study, list))
    fmt::print("\n{}\n\n{}", name, to_plain(table));
  for (const Result& result : list)
    if (result.finding.told().status == Status::failed)
      fmt::print("\nfailed: {} {}: {}\n", result.finding.case_id, result.finding.method, result.finding.told().message);
  fmt::print("\nReport: {}\n", file.string());
}

} // namespace studies
