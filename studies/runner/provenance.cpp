#include "studies/runner/provenance.hpp"

#include "pfv/problem/text.hpp"
#include "reference/answer.hpp"
#include "studies/runner/finding.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <set>
#include <utility>

namespace studies {

namespace {

using Values = std::set<std::string>;

std::string joined(const Values& values) {
  // Beyond a few, the values belong to single runs: they are in the stored answers.
  if (values.size() > 4)
    return fmt::format("{} different values, from {} to {}", values.size(), *values.begin(), *values.rbegin());
  return fmt::format("{}", fmt::join(values, "; "));
}

Values distinct(std::span<const Row> rows, std::string Row::*member) {
  Values values;
  for (const Row& row : rows)
    if (!(row.*member).empty())
      values.insert(row.*member);
  return values;
}

} // namespace

Table provenance(std::span<const Row> rows) {
  const std::pair<const char*, std::string Row::*> facts[] = {{"commit", &Row::commit},
                                                              {"sources of the answers", &Row::answer_sources},
                                                              {"compiler", &Row::compiler},
                                                              {"flags", &Row::flags},
                                                              {"machine", &Row::machine}};
  Table table{{{"what"}, {"value"}}, {}};
  for (const auto& [what, member] : facts)
    table.rows.push_back({what, joined(distinct(rows, member))});
  const Values dates = distinct(rows, &Row::started);
  if (!dates.empty())
    table.rows.push_back({"run (UTC)", *dates.begin() == *dates.rbegin()
                                           ? *dates.begin()
                                           : fmt::format("{} to {}", *dates.begin(), *dates.rbegin())});
  return table;
}

Table method_notes(std::span<const Row> rows, const std::filesystem::path& answers) {
  std::map<std::pair<std::string, std::string>, Values> notes;
  for (const Row& row : rows) {
    if (!row.method_version.empty())
      notes[{row.method, "version"}].insert(row.method_version);
    const auto file = answer_file(answers, row.key);
    if (row.status != Status::answered || damage_of(file))
      continue;
    for (const auto& [name, value] : reference::answer_from_json(pfv::read_text(file)).notes)
      notes[{row.method, name}].insert(value);
  }
  Table table{{{"method"}, {"note"}, {"value"}}, {}};
  for (const auto& [about, values] : notes)
    table.rows.push_back({about.first, about.second, joined(values)});
  return table;
}

} // namespace studies
