#include "studies/runner/index_page.hpp"

#include "pfv/problem/text.hpp"
#include "studies/document/markdown.hpp"

#include <fmt/format.h>

namespace studies {

namespace {

std::string link_to(const std::string& name, const std::filesystem::path& file, const std::filesystem::path& from) {
  return fmt::format("[{}]({})", name, std::filesystem::relative(file, from).generic_string());
}

/// "2000-01-01", or "2000-01-01 to 2000-01-02", of the times of the first and the last run.
std::string days_of(const std::string& times) {
  constexpr std::size_t day = 10;
  const auto to = times.find(" to ");
  const std::string first = times.substr(0, day);
  const std::string last = to == times.npos ? first : times.substr(to + 4, day);
  return first == last ? first : first + " to " + last;
}

std::vector<std::string> line_of(const IndexEntry& entry, const std::filesystem::path& index_folder) {
  const auto text = entry.folder / "report.md", page = entry.folder / "report.html";
  if (!std::filesystem::is_regular_file(text))
    return {entry.name, entry.title, fmt::format("no report; `study run {}` makes it", entry.name), "", ""};
  const Document report = from_markdown(pfv::read_text(text));
  const bool has_page = std::filesystem::is_regular_file(page);
  return {link_to(entry.name, has_page ? page : text, index_folder), report.title, outcome_of(report),
          days_of(fact_of(report, "run (UTC)")), fact_of(report, "commit")};
}

} // namespace

Document index_page(std::span<const IndexEntry> entries, const std::filesystem::path& index_folder) {
  Document page{"Studies", {}};
  page.add(Paragraph{"What has been asked and how it came out. Each line leads to its report."});
  Table table{{{"study"}, {"what it is about"}, {"outcome"}, {"run (UTC)"}, {"commit"}}, {}};
  for (const IndexEntry& entry : entries)
    table.rows.push_back(line_of(entry, index_folder));
  page.add(table);
  return page;
}

} // namespace studies
